import { curveDemo } from "./figure.ts";
import { escapeHtml, lines } from "./html.ts";
import type { EmbedPage, Html } from "./types.ts";

/**
 * One demo that fills its frame. The page does not know its language before its query is read, so the
 * heading, for those who hear the page, stands in both.
 */
export function embedPage({ title, figure }: EmbedPage): Html {
  return lines(
    '<main class="embed">',
    `<h1 class="unseen"><span lang="de">${escapeHtml(title.de)}</span> <span lang="en">${escapeHtml(title.en)}</span></h1>`,
    curveDemo(figure),
    "</main>",
  );
}
