import type Token from "markdown-it/lib/token.mjs";
import type { Demo } from "../../demo/index.ts";
import type { State } from "../../demo/param.ts";
import type { Lang } from "../../words/words.ts";
import type { Problem } from "../problem.ts";
import type { FigureData, Html } from "../templates/types.ts";
import type { GlossaryEntry } from "../tex/annotate.ts";
import type { FigureNames } from "../tex/figure-names.ts";

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
  /** The figure's own state; null if there is no such demo. */
  readonly own: State | null;
}

/** A displayed formula, and the check that proves it. */
export interface LessonFormula {
  readonly line: number;
  /** Id of its check; null for none. */
  readonly check: string | null;
  /** Whether it states nothing that could be computed. */
  readonly notation: boolean;
}

/** What the place of a token in the text means for the formula in it; blocks write it, the TeX rule reads it. */
export interface FormulaMeta {
  /** The figure to which its symbols belong, if the author names one. */
  readonly figure?: string | undefined;
  readonly id?: string | null;
  readonly check?: string | null;
  readonly notation?: boolean;
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
  readonly patch: State;
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
  /** Formulas that checks were written for, by the checks' ids. */
  readonly identities: ReadonlyMap<string, string>;
  readonly problems: Problem[];
  /** The symbols of the lesson. */
  readonly glossary: GlossaryEntry[];
  readonly formulas: LessonFormula[];
  /** Where the reader's guess begins, in figures where it is a place: `view x,y`. */
  readonly guesses: Map<string, string>;
  /** Names of each figure, once somebody has asked for them. */
  readonly names: Map<string, FigureNames | null>;
  readonly headings: Heading[];
  readonly anchors: Anchor[];
  readonly figures: LessonFigure[];
  readonly links: LessonLink[];
  readonly stateLinks: LessonStateLink[];
  /** Headings, figures, formulas, blocks in order: what both languages must share. */
  readonly skeleton: Bone[];
}

export function newEnv(
  given: Pick<LessonEnv, "file" | "lang" | "source" | "demos" | "still" | "readSource" | "identities">,
): LessonEnv {
  const { file, lang, source, demos, still, readSource, identities } = given;
  return {
    file,
    lang,
    source,
    demos,
    still,
    readSource,
    identities,
    problems: [],
    glossary: [],
    formulas: [],
    guesses: new Map(),
    names: new Map(),
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
