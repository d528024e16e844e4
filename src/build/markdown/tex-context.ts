import type Token from "markdown-it/lib/token.mjs";
import type { TexContext } from "../tex/annotate.ts";
import { type FigureNames, figureNames } from "../tex/figure-names.ts";
import { type FormulaMeta, type LessonEnv, type LessonFigure, lineOf } from "./env.ts";

/** What a formula's symbols may be tied to, at its place in the text. */
export function texContext(token: Token, env: LessonEnv): TexContext {
  const meta = token.meta as FormulaMeta | null;
  const line = lineOf(token);
  const figure = meta?.figure ?? nearestFigure(line, env);
  const away = (one: LessonFigure) => (one.id === figure ? -1 : Math.abs(one.line - line));
  return {
    lang: env.lang,
    glossary: env.glossary,
    figure,
    figures: [...env.figures].sort((a, b) => away(a) - away(b)).map(({ id }) => id),
    names: (id) => namesOf(id, env),
  };
}

/**
 * The figure that a formula speaks of if it does not say so: within its section the last one before it, else the first one
 * after it; in a section without figures the last one before, at the start of a lesson the first one after.
 */
function nearestFigure(line: number, { figures, headings }: LessonEnv): string | null {
  const sections = headings.filter(({ level }) => level === 2).map((heading) => heading.line);
  const start = sections.filter((one) => one <= line).at(-1) ?? 0;
  const end = sections.find((one) => one > line) ?? Infinity;
  const before = figures.filter((figure) => figure.line < line);
  const after = figures.filter((figure) => figure.line >= line);
  const here =
    before.filter((figure) => figure.line > start).at(-1) ?? after.find((figure) => figure.line < end);
  return (here ?? before.at(-1) ?? after[0])?.id ?? null;
}

/** All names of a figure of the lesson; null if there is no such figure. */
export function namesOf(id: string, env: LessonEnv): FigureNames | null {
  const known = env.names.get(id);
  if (known !== undefined) return known;
  const figure = env.figures.find((one) => one.id === id);
  const demo = figure && env.demos.get(figure.demo);
  const patches = env.stateLinks.filter((link) => link.figure === id).map(({ patch }) => patch);
  const names = demo && figure.own ? figureNames(demo, figure.own, patches) : null;
  env.names.set(id, names);
  return names;
}
