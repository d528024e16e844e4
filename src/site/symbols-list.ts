import { formatNumber, formatPoint } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { type Lighting, livingDemo, readTie } from "./lighting.ts";
import { putBeside } from "./put-beside.ts";
import { meaningOf } from "./symbol-meaning.ts";

/**
 * A line of the list, as the build wrote it: how it is spoken, `figure/name` or null, its entry in the glossary, and where
 * its value is if not under its name.
 */
type Entry = readonly [say: string, tie: string | null, entry: number | null, value?: string];

/**
 * The button after a formula opens the list of its symbols, with meaning and present value. The arrow keys go through
 * them, and what has the focus lights up in the figure.
 */
export function symbolsList(button: HTMLButtonElement, lang: Lang, { point }: Lighting): void {
  const formula = button.closest(".equation")!;
  let list: HTMLElement | null = null;

  const open = () => {
    const made = document.createElement("ul");
    made.className = "symbols-list";
    made.popover = "auto";
    made.setAttribute("role", "listbox");
    made.setAttribute("aria-label", button.getAttribute("aria-label") ?? "");
    const entries = JSON.parse(button.dataset.symbols ?? "[]") as readonly Entry[];
    made.append(...entries.map((entry) => option(entry, formula, lang)));
    made.addEventListener("toggle", (event) => {
      if ((event as ToggleEvent).newState === "open") return;
      button.setAttribute("aria-expanded", "false");
      point([]);
      list = null;
      made.remove();
    });
    made.addEventListener("focusin", ({ target }) => choose(made, target as HTMLElement));
    made.addEventListener("pointerover", ({ target }) => {
      (target as Element).closest<HTMLElement>("[role=option]")?.focus({ preventScroll: true });
    });
    made.addEventListener("focusout", ({ relatedTarget }) => {
      if (relatedTarget && !made.contains(relatedTarget as Node)) made.hidePopover();
    });
    made.addEventListener("keydown", (event) => walk(event, made));
    button.after(made);
    made.showPopover();
    putBeside(made, button.getBoundingClientRect());
    button.setAttribute("aria-expanded", "true");
    list = made;
    (made.firstElementChild as HTMLElement).focus();
  };
  const choose = (made: HTMLElement, chosen: HTMLElement) => {
    for (const one of made.children as Iterable<HTMLElement>) {
      one.tabIndex = one === chosen ? 0 : -1;
      one.setAttribute("aria-selected", String(one === chosen));
    }
    point(chosen.dataset.name ? [readTie(chosen.dataset.name)] : []);
  };
  // A click on the button has closed the list before it is heard here.
  let wasOpen = false;
  button.addEventListener("pointerdown", () => {
    wasOpen = list !== null;
  });
  button.addEventListener("click", () => {
    if (list) list.hidePopover();
    else if (!wasOpen) open();
    wasOpen = false;
  });
}

function walk(event: KeyboardEvent, list: HTMLElement): void {
  const all = [...list.children] as HTMLElement[];
  const now = all.indexOf(document.activeElement as HTMLElement);
  const to = { ArrowDown: now + 1, ArrowUp: now - 1, Home: 0, End: all.length - 1 }[event.key];
  if (to === undefined) return;
  event.preventDefault();
  all[(to + all.length) % all.length]!.focus();
}

function option([say, tie, entry, value]: Entry, formula: Element, lang: Lang): HTMLElement {
  const item = document.createElement("li");
  item.setAttribute("role", "option");
  item.tabIndex = -1;
  if (tie) item.dataset.name = tie;
  const symbol = formula.querySelector<HTMLElement>(tie ? `[data-tie="${tie}"]` : `[data-symbol="${entry}"]`);
  const eyes = span("symbol katex", ...(symbol ? [symbol.cloneNode(true)] : []));
  eyes.setAttribute("aria-hidden", "true");
  if (symbol?.dataset.index) eyes.dataset.index = symbol.dataset.index;
  const words = [span("spoken", `${say}: `), span("meaning", ...(meaningOf(String(entry)) ?? []))];
  item.append(eyes, ...words, span("value", presentValue(value ?? tie, lang)));
  return item;
}

/** The present value of what a symbol is tied to; nothing for what has none, or while the figure sleeps. */
function presentValue(tie: string | null, lang: Lang): string {
  if (!tie) return "";
  const { figure, name } = readTie(tie);
  const values: unknown = livingDemo(figure)?.values;
  const path = name.split(".");
  const value = path.reduce<unknown>((at, key) => {
    // The points of a net are numbered in one row.
    const inNet = path.length === 2 && Array.isArray(at) && Array.isArray(at[0]) && Array.isArray(at[0][0]);
    return ((inNet ? at.flat() : at) as Record<string, unknown> | undefined)?.[key];
  }, values);
  if (typeof value === "number") return `= ${formatNumber(value, lang, 3)}`;
  const isPoint = Array.isArray(value) && value.length < 4 && value.every((x) => typeof x === "number");
  return isPoint ? `= ${formatPoint(value as number[], lang)}` : "";
}

function span(name: string, ...children: readonly (Node | string)[]): HTMLElement {
  const made = document.createElement("span");
  made.className = name;
  made.append(...children);
  return made;
}
