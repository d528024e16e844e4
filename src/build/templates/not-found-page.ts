import { BOOT } from "./boot.ts";
import { attributes, lines } from "./html.ts";
import { logo } from "./logo.ts";
import type { Html, NotFoundPage } from "./types.ts";
import { SITE_NAME } from "./words.ts";

/** The style sheet of the page that is not there, after the theme's colours; in the page itself. */
export const NOT_FOUND_CSS = `
:root{color-scheme:light dark}
[data-theme="light"]{color-scheme:light}
[data-theme="dark"]{color-scheme:dark}
body{margin:0;min-height:100vh;display:grid;place-content:center;gap:2.5rem;padding:2rem;box-sizing:border-box;background:var(--paper);color:var(--ink);font:1.1875rem/1.55 "Source Serif 4",Georgia,serif}
header{display:flex;gap:.7rem;align-items:center;font-weight:600;font-size:1.3rem}
path{fill:none;stroke:var(--lath);stroke-width:3;stroke-linecap:round}
circle{fill:var(--ink)}
main{display:grid;gap:2.5rem;max-width:34rem}
h1,h2{margin:0 0 .5rem;font-size:1.6rem;font-weight:600;line-height:1.2}
p{margin:0 0 .75rem;text-wrap:pretty}
.picture{width:min(24rem,100%);height:auto;overflow:visible}
.picture .gap{stroke:var(--soft);stroke-width:2;stroke-dasharray:1 7}
a{color:inherit;text-underline-offset:.2em}
:focus-visible{outline:2px solid var(--lath);outline-offset:3px}
`;

/**
 * The page for addresses that lead nowhere. A host shows it at any depth, so that it may refer to nothing
 * beside it: styles and picture are its own, and a link home only stands where the site knows its address.
 */
export function notFoundPage({ css, csp, home }: NotFoundPage): Html {
  return `${lines(
    "<!doctype html>",
    '<html lang="de">',
    "<head>",
    '<meta charset="utf-8">',
    csp !== null && `<meta${attributes({ "http-equiv": "Content-Security-Policy", content: csp })}>`,
    '<meta name="viewport" content="width=device-width, initial-scale=1">',
    `<title>Nicht gefunden / Not found · ${SITE_NAME}</title>`,
    '<meta name="robots" content="noindex">',
    '<link rel="icon" href="data:,">',
    `<script>${BOOT}</script>`,
    `<style>${css}</style>`,
    "</head>",
    "<body>",
    `<header>${logo()}${SITE_NAME}</header>`,
    "<main>",
    lathWithGap(),
    "<section>",
    "<h1>Hier ist keine Seite</h1>",
    "<p>Die Adresse führt ins Leere. Vielleicht ist sie verschrieben; oft hilft es, den letzten Teil wegzulassen.</p>",
    home !== null && `<p><a${attributes({ href: `${home}de/` })}>Zur Startseite</a></p>`,
    "</section>",
    '<section lang="en">',
    "<h2>There is no page here</h2>",
    "<p>This address leads nowhere. It may be misspelt; leaving out its last part often helps.</p>",
    home !== null && `<p><a${attributes({ href: `${home}en/` })}>To the front page</a></p>`,
    "</section>",
    "</main>",
    "</body>",
    "</html>",
  )}\n`;
}

/** The lath of the front page's first picture, with a piece missing between its second and third weight. */
function lathWithGap(): Html {
  const weights = [
    [14, 112],
    [62, 80],
    [112, 59],
    [168, 50],
    [226, 57],
  ].map(([x, y]) => `<circle cx="${x}" cy="${y}" r="4"/>`);
  const pieces = [
    '<path d="M14 112C30 100.5 46 89 62 80"/>',
    '<path class="gap" d="M62 80C78.7 70.6 95.3 64 112 59"/>',
    '<path d="M112 59C130.7 53.5 149.3 50.1 168 50C187.3 49.9 206.7 53.5 226 57"/>',
  ];
  return `<svg class="picture" viewBox="0 40 240 84" aria-hidden="true">${pieces.join("")}${weights.join("")}</svg>`;
}
