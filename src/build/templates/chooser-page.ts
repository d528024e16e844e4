import { lines } from "./html.ts";
import { logo } from "./logo.ts";
import type { Html } from "./types.ts";
import { SITE_NAME } from "./words.ts";

/** The page at the root: the two languages. The choice is remembered, and the next visit goes on at once. */
export function chooserPage(): Html {
  return lines(
    '<main class="chooser">',
    `<h1>${logo()}<span class="wordmark">${SITE_NAME}</span></h1>`,
    '<ul class="languages">',
    choice("de", "Deutsch", "Kurven und Flächen zum Anfassen"),
    choice("en", "English", "Curves and surfaces to take hold of"),
    "</ul>",
    "</main>",
  );
}

function choice(lang: string, name: string, line: string): Html {
  return `<li lang="${lang}"><a href="${lang}/" hreflang="${lang}" data-language="${lang}"><strong>${name}</strong><span>${line}</span></a></li>`;
}
