import { attributes } from "./html.ts";
import type { Html, StateLinkData } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * Words that put a figure into a state: an ordinary link to the figure, with the state behind its id. Where
 * the dots cannot be seen, words say what the link does; they also name a link that is nothing but a formula.
 */
export function stateLink({ lang, figure, query, html }: StateLinkData): Html {
  const says = `<span class="unseen"> (${WORDS[lang].inTheFigure})</span>`;
  return `<a${attributes({ class: "state-link", href: `#${figure}?${query}` })}>${html}${says}</a>`;
}
