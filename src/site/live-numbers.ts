import type { CurveDemo } from "../player/index.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { readTie } from "./lighting.ts";

interface Live {
  readonly text: Text;
  readonly path: readonly string[];
  readonly digits: number;
  /** Signs for which there is room. */
  readonly room: number;
  /** The formula that must be seen for the number to follow at once; null for what is only heard. */
  readonly formula: Element | null;
}

/**
 * Numbers in formulas follow their figures. Only the text of a number is replaced, in room that was kept for it; formulas
 * off the screen catch up when they come into sight. What is heard follows when a change is complete.
 */
export function liveNumbers(main: HTMLElement, lang: Lang): void {
  const byFigure = new Map<string, Live[]>();
  for (const element of main.querySelectorAll<HTMLElement>("[data-live]")) {
    const { figure, name } = readTie(element.getAttribute("data-live")!);
    const list = byFigure.get(figure) ?? [];
    byFigure.set(figure, list);
    list.push({
      text: element.firstChild as Text,
      path: name.split("."),
      digits: Number(element.getAttribute("data-digits")),
      room: Number(element.getAttribute("data-room") ?? Infinity),
      formula: element.closest("math") ? null : element.closest(".formula, .katex"),
    });
  }
  if (byFigure.size === 0) return;

  const seen = new Set<Element>();
  const stale = new Map<Element, CurveDemo>();
  const write = (demo: CurveDemo, numbers: readonly Live[]) => {
    const { values } = demo;
    for (const { text, path, digits, room } of numbers) {
      const now = written(valueAt(values, path), digits, lang);
      if (text.data === now) continue;
      const [was, is] = [text.data.length > room, now.length > room];
      if (was !== is) text.parentElement!.classList.toggle("is-wide", is);
      text.data = now;
    }
  };
  const numbersIn = (formula: Element) =>
    [...byFigure.values()].flatMap((list) => list.filter((live) => live.formula === formula));
  const near = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (!isIntersecting) {
        seen.delete(target);
        continue;
      }
      seen.add(target);
      const demo = stale.get(target);
      if (demo) write(demo, numbersIn(target));
      stale.delete(target);
    }
  });
  for (const formula of new Set(
    [...byFigure.values()].flatMap((list) => list.flatMap((live) => live.formula ?? [])),
  ))
    near.observe(formula);

  const follow = (event: Event) => {
    const demo = event.target as CurveDemo;
    const numbers = byFigure.get(demo.closest("figure")?.id ?? "");
    if (!numbers) return;
    const committed = (event as CustomEvent<{ committed: boolean } | null>).detail?.committed !== false;
    write(
      demo,
      numbers.filter(({ formula }) => (formula ? seen.has(formula) : committed)),
    );
    for (const { formula } of numbers) if (formula && !seen.has(formula)) stale.set(formula, demo);
  };
  main.addEventListener("statechange", follow);
  main.addEventListener("curve-demo-ready", follow);
}

function valueAt(values: unknown, path: readonly string[]): unknown {
  return path.reduce((at, key) => (at as Record<string, unknown> | null | undefined)?.[key], values);
}

function written(value: unknown, digits: number, lang: Lang): string {
  if (typeof value === "number") return formatNumber(value, lang, digits, true);
  return Array.isArray(value) ? formatPoint(value as number[], lang, digits, true) : "–";
}
