import type { Lesson } from "./compile-lesson.ts";

/** How many displayed formulas that state something are proved by a check, over all lessons. */
export interface Coverage {
  readonly covered: number;
  readonly total: number;
  /** Formulas that could carry a check, and do not. */
  readonly open: readonly { readonly file: string; readonly line: number }[];
}

/** Both languages have the same formulas, so the German ones are counted. */
export function coverageOf(lessons: readonly Lesson[]): Coverage {
  const all = lessons
    .filter(({ lang }) => lang === "de")
    .flatMap(({ file, formulas }) => formulas.map((formula) => ({ file, ...formula })))
    .filter(({ notation }) => !notation);
  const open = all.filter(({ check }) => check === null).map(({ file, line }) => ({ file, line }));
  return { covered: all.length - open.length, total: all.length, open };
}

/** The line that the build prints. */
export function coverageText({ covered, total }: Coverage): string {
  const share = total === 0 ? "" : ` (${Math.floor((100 * covered) / total)} %)`;
  return `identities: ${covered} of ${total} displayed formulas carry a check${share}`;
}
