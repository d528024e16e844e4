import type Token from "markdown-it/lib/token.mjs";
import type { Demo } from "../../demo/index.ts";
import type { State } from "../../demo/param.ts";
import type { Lang } from "../../words/words.ts";
import type { Problem } from "../problem.ts";
import type { FigureData, Html } from "../templates/types.ts";

/** A heading of a lesson, or another place with an id. */
export interface Anchor {
  readonly id: string;
  readonly line: number;
}

export interface Heading extends Anchor {
  readonly level: number;
  html: Html;
}

/** A demo in a lesson. */
export interface LessonFigure extends Anchor {
  readonly demo: string;
}

/** A link whose end is checked once all lessons are known. */
export interface LessonLink {
  readonly line: number;
  /** null: this lesson. */
  readonly lesson: string | null;
  readonly anchor: string | null;
}

/** A link that puts a figure of the same lesson into a state; checked when the whole text is read. */
export interface LessonStateLink {
  readonly line: number;
  readonly figure: string;
  readonly query: string;
}

/** A part of the lesson that the other language must have at the same place. */
export interface Bone {
  readonly line: number;
  /** What it is, in words for a message; equal in both languages. */
  readonly sign: string;
}

/** Makes the still picture of a demo in a state. */
export type Still = (demo: Demo, state: State, lang: Lang) => Pick<FigureData, "box" | "svg">;

/** What the rules know and gather while they read one lesson. */
export interface LessonEnv {
  readonly file: string;
  readonly lang: Lang;
  /** The text, line by line. */
  readonly source: readonly string[];
  readonly demos: ReadonlyMap<string, Demo>;
  readonly still: Still;
  /** The lines of a file of the project, for blocks that show code; null if there is none. */
  readonly readSource: (path: string) => string | null;
  readonly problems: Problem[];
  readonly headings: Heading[];
  readonly anchors: Anchor[];
  readonly figures: LessonFigure[];
  readonly links: LessonLink[];
  readonly stateLinks: LessonStateLink[];
  /** Headings, figures, formulas, blocks in order: what both languages must share. */
  readonly skeleton: Bone[];
}

export function newEnv(
  given: Pick<LessonEnv, "file" | "lang" | "source" | "demos" | "still" | "readSource">,
): LessonEnv {
  const { file, lang, source, demos, still, readSource } = given;
  return {
    file,
    lang,
    source,
    demos,
    still,
    readSource,
    problems: [],
    headings: [],
    anchors: [],
    figures: [],
    links: [],
    stateLinks: [],
    skeleton: [],
  };
}

export function report(env: LessonEnv, line: number, message: string, remedy: string): void {
  env.problems.push({ file: env.file, line, message, remedy });
}

/** The line (from 1) on which a token begins. */
export function lineOf(token: Token): number {
  return (token.map?.[0] ?? 0) + 1;
}

/** Takes an id for a place of the page; twice the same is a problem. */
export function addAnchor(env: LessonEnv, id: string, line: number): void {
  const before = env.anchors.find((anchor) => anchor.id === id);
  if (!/^[a-z][a-z0-9-]*$/.test(id)) {
    report(env, line, `the id "${id}" is not of the form a-b-c`, "use small letters, digits and hyphens");
  } else if (before) {
    report(env, line, `the id "${id}" is taken already (line ${before.line})`, "give each place its own id");
  }
  env.anchors.push({ id, line });
}
