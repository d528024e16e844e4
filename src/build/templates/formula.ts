import { attributes } from "./html.ts";
import type { FormulaData, Html } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * A displayed formula. The box takes the keyboard's focus only where it really scrolls; the page's script
 * sees to that, and the label is there for it.
 */
export function formula(data: FormulaData): Html {
  const label = data.words || WORDS[data.lang].formula;
  return `<div${attributes({ class: "formula", id: data.id, "data-label": label })}>${data.html}</div>`;
}
