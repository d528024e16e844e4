import { attributes } from "./html.ts";
import type { Html, StateLinkData } from "./types.ts";

/** Words that put a figure into a state: an ordinary link to the figure, with the state behind its id. */
export function stateLink({ figure, query, html }: StateLinkData): Html {
  return `<a${attributes({ class: "state-link", href: `#${figure}?${query}` })}>${html}</a>`;
}
