import { attributes } from "./html.ts";
import type { Html, TableData } from "./types.ts";
import { WORDS } from "./words.ts";

/** A table in a box that scrolls where the column is too narrow for it. */
export function table({ lang, html }: TableData): Html {
  return `<div${attributes({ class: "table", "data-label": WORDS[lang].table })}>${html}</div>`;
}
