import { existsSync, readFileSync } from "node:fs";
import { join, normalize } from "node:path";
import { hero, parts } from "../../lessons/toc.ts";
import type { Demo } from "../demo/index.ts";
import { demos as registry } from "../demos/index.ts";
import { identities } from "../identities/index.ts";
import { LANGS } from "../words/words.ts";
import type { Assets } from "./assets.ts";
import type { Workbench } from "./compile-lesson.ts";
import { type Course, makeCourse, readLessonFiles } from "./course.ts";
import { type Coverage, coverageOf } from "./coverage.ts";
import { chooser } from "./pages/chooser.ts";
import { embed } from "./pages/embed.ts";
import { front } from "./pages/front.ts";
import { lessonBody } from "./pages/lesson.ts";
import { notFound } from "./pages/not-found.ts";
import type { Page, PageContext } from "./pages/page.ts";
import { renderPage } from "./pages/render-page.ts";
import type { Problem } from "./problem.ts";
import { still } from "./still.ts";

/** The whole site as it stands in the sources: its pages, and what is wrong with them. */
export interface Site {
  readonly pages: readonly Page[];
  readonly problems: readonly Problem[];
  /** How many displayed formulas are proved by a check. */
  readonly coverage: Coverage;
  /** The document of one page. */
  render(page: Page, assets: Assets): string;
  /** The page that a host shows for addresses that lead nowhere. */
  notFound(options: Pick<SiteOptions, "policy" | "siteUrl">): string;
}

export interface SiteOptions {
  /** The project's folder. */
  readonly root: string;
  /** Whether pages carry the content security policy (not in the dev server). */
  readonly policy: boolean;
  /** Where the site will stand, for absolute addresses; null if unknown. */
  readonly siteUrl: string | null;
}

/**
 * Reads lessons and demos and makes the list of pages. This module and all it imports are loaded through
 * Vite, so that the dev server sees every change.
 */
export async function openSite({ root, policy, siteUrl }: SiteOptions): Promise<Site> {
  const demos = await loadDemos();
  const bench: Workbench = {
    demos,
    still,
    readSource: (path) => readInside(root, path),
    identities: new Map(Object.entries(identities).map(([id, { formula }]) => [id, formula])),
  };
  const course = makeCourse(readLessonFiles(root), parts, bench);
  const context: PageContext = { course, parts, demos, still, hero };
  return {
    pages: listPages(context),
    problems: course.problems,
    coverage: coverageOf(course.lessons),
    render: (page, assets) => renderPage(page, context, { assets, policy, siteUrl }),
    notFound,
  };
}

async function loadDemos(): Promise<ReadonlyMap<string, Demo>> {
  const loaded = await Promise.all(
    Object.entries(registry).map(async ([id, load]) => {
      const demo = (await load()).default;
      if (demo.id !== id)
        throw new RangeError(`src/demos/index.ts: "${id}" leads to the demo "${demo.id}"; name both alike`);
      return [id, demo] as const;
    }),
  );
  return new Map(loaded);
}

/** A file of the project's sources; nothing outside them. */
function readInside(root: string, path: string): string | null {
  const file = join(root, normalize(path));
  return file.startsWith(join(root, "src")) && existsSync(file) ? readFileSync(file, "utf8") : null;
}

function listPages(context: PageContext): Page[] {
  const { course, demos } = context;
  return [
    chooser(),
    ...LANGS.map((lang) => front(lang, context)),
    ...lessonIds(course).flatMap((id) => LANGS.map((lang) => lessonBody(id, lang, context))),
    ...[...demos.values()].map((demo) => embed(demo, context)),
  ];
}

/** Lessons that can be shown in both languages. */
function lessonIds({ lessons }: Course): string[] {
  const ids = [...new Set(lessons.map(({ id }) => id))];
  return ids.filter((id) => LANGS.every((lang) => lessons.some((one) => one.id === id && one.lang === lang)));
}
