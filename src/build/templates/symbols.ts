import { attributes } from "./html.ts";
import type { Html, SymbolsData } from "./types.ts";
import { WORDS } from "./words.ts";

/** The glossary of a lesson: symbol and meaning. What the page shows beside a symbol is taken from here. */
export function symbols({ lang, id, entries }: SymbolsData): Html {
  const rows = entries.map(
    ({ number, symbol, meaning }) =>
      `<div${attributes({ id: `symbol-${number}` })}><dt>${symbol}</dt><dd>${meaning}</dd></div>`,
  );
  return `<div${attributes({ class: "block symbols", id })}>
<p class="block-name"><strong>${WORDS[lang].symbolsOfLesson}</strong></p>
<dl>
${rows.join("\n")}
</dl>
</div>`;
}
