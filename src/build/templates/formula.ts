import { attributes } from "./html.ts";
import type { FormulaData, Html } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * A displayed formula. The box takes the keyboard's focus only where it really scrolls; the page's script
 * sees to that, and the label is there for it. The symbols that mean something are listed behind one button: nothing
 * within the formula takes the focus.
 */
export function formula(data: FormulaData): Html {
  const words = WORDS[data.lang];
  const label = data.words || words.formula;
  const own = data.symbols.length > 0 ? null : data.id;
  const box = `<div${attributes({ class: "formula", id: own, "data-label": label })}>${data.html}</div>`;
  if (data.symbols.length === 0) return box;
  const list = data.symbols.map(({ say, tie, entry, value }) =>
    value ? [say, tie, entry, value] : [say, tie, entry],
  );
  const glyphs = data.symbols.flatMap(({ glyph }) => glyph ?? []).join("");
  const hidden = glyphs && `<div class="glyphs" hidden>${glyphs}</div>`;
  const button = `<button${attributes({
    type: "button",
    class: "symbols-button",
    "aria-haspopup": "listbox",
    "aria-expanded": "false",
    "aria-label": words.symbolsOfFormula,
    "data-symbols": JSON.stringify(list),
  })}>${words.symbols}</button>`;
  return `<div${attributes({ class: "equation", id: data.id })}>${hidden}${box}${button}</div>`;
}
