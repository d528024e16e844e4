import type { Part } from "../../../lessons/toc.ts";
import type { Demo } from "../../demo/index.ts";
import type { Lang } from "../../words/words.ts";
import type { PageAssets } from "../assets.ts";
import type { Lesson } from "../compile-lesson.ts";
import type { Course } from "../course.ts";
import type { Still } from "../markdown/env.ts";
import type { Html, Path, Text } from "../templates/types.ts";

/** One page of the site before it is written. */
export interface Page {
  /** Folder below the root: "de/bezier/"; "" for the root itself. */
  readonly path: Path;
  readonly lang: Lang;
  readonly title: Text;
  readonly description: Text;
  readonly bodyClass: string;
  readonly assets: "page" | "embed";
  /** The same page in the other language; null where one page serves both. */
  readonly alternate: Path | null;
  /** Header, navigation and footer around the body; null for none. */
  readonly chrome: { readonly lesson: Lesson | null } | null;
  readonly noindex?: boolean;
  /** The markdown that the page is made of, for messages while writing; empty for none. */
  readonly sources: readonly string[];
  body(root: string): Html;
}

/** What pages are made from. */
export interface PageContext {
  readonly course: Course;
  readonly parts: readonly Part[];
  readonly demos: ReadonlyMap<string, Demo>;
  readonly still: Still;
  readonly hero: { readonly demo: string; readonly query: string; readonly lesson: string };
}

/** What the surroundings of a page come from. */
export interface PageOptions {
  readonly assets: Record<Page["assets"], PageAssets>;
  readonly policy: boolean;
  readonly siteUrl: string | null;
}

export function otherLang(lang: Lang): Lang {
  return lang === "de" ? "en" : "de";
}

/** The way from a page back to the root: "", "../", "../../". */
export function rootOf(path: Path): string {
  return "../".repeat(path.split("/").length - 1);
}
