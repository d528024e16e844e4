import type MarkdownIt from "markdown-it";
import type { Demo } from "../demo/index.ts";
import type { Lang } from "../words/words.ts";
import { type FrontMatter, splitFrontMatter } from "./front-matter.ts";
import {
  type Anchor,
  type Bone,
  type Heading,
  type LessonEnv,
  type LessonFigure,
  type LessonFormula,
  type LessonLink,
  type LessonStateLink,
  newEnv,
  type Still,
} from "./markdown/env.ts";
import { createMarkdown } from "./markdown/index.ts";
import type { Problem } from "./problem.ts";
import type { Html } from "./templates/types.ts";

/** One lesson in one language, as markup, with what other places need to know of it. */
export interface Lesson {
  readonly id: string;
  readonly lang: Lang;
  readonly file: string;
  readonly front: Omit<FrontMatter, "lead" | "goals"> & {
    readonly lead: Html;
    readonly goals: readonly Html[];
  };
  readonly body: Html;
  readonly headings: readonly Heading[];
  readonly anchors: readonly Anchor[];
  readonly figures: readonly LessonFigure[];
  readonly links: readonly LessonLink[];
  readonly stateLinks: readonly LessonStateLink[];
  readonly formulas: readonly LessonFormula[];
  readonly skeleton: readonly Bone[];
}

export interface LessonSource {
  readonly id: string;
  readonly lang: Lang;
  /** Path below the project's root. */
  readonly file: string;
  readonly source: string;
}

/** What the text refers to. */
export interface Workbench {
  readonly demos: ReadonlyMap<string, Demo>;
  readonly still: Still;
  readonly readSource: (path: string) => string | null;
  /** Formulas that checks were written for, by the checks' ids. */
  readonly identities: ReadonlyMap<string, string>;
}

let markdown: MarkdownIt | undefined;

/**
 * Reads one language of a lesson. All problems are gathered; `lesson` is null only if the front matter is of
 * no use.
 */
export function compileLesson(
  { id, lang, file, source }: LessonSource,
  bench: Workbench,
): { readonly lesson: Lesson | null; readonly problems: readonly Problem[] } {
  const { front, text, problems } = splitFrontMatter(file, source);
  if (!front) return { lesson: null, problems };
  markdown ??= createMarkdown();
  const env = newEnv({ file, lang, source: text.split("\n"), ...bench });
  const body = markdown.render(text, env);
  const inline = ({ value, line }: { value: string; line: number }) => renderInline(value, line, env);
  const lesson: Lesson = {
    id,
    lang,
    file,
    front: { ...front, lead: inline(front.lead), goals: front.goals.map(inline) },
    body,
    headings: env.headings,
    anchors: env.anchors,
    figures: env.figures,
    links: env.links,
    stateLinks: env.stateLinks,
    formulas: env.formulas,
    skeleton: env.skeleton,
  };
  return { lesson, problems: [...problems, ...env.problems] };
}

/** A line of the front matter; its problems bear the line it stands in. */
function renderInline(value: string, line: number, lesson: LessonEnv): Html {
  const env = newEnv({ ...lesson, source: [] });
  const html = markdown!.renderInline(value, env);
  lesson.problems.push(...env.problems.map((problem) => ({ ...problem, line })));
  lesson.links.push(...env.links.map((link) => ({ ...link, line })));
  return html;
}
