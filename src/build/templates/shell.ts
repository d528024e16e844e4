import { readFileSync } from "node:fs";
import { chrome } from "./chrome.ts";
import { attributes, escapeHtml, lines } from "./html.ts";
import type { Html, ShellPage } from "./types.ts";
import { SITE_NAME } from "./words.ts";

const TEMPLATE = new URL("../../../index.html", import.meta.url);

/**
 * The whole document of a page: the project's index.html with its places filled. The template is read anew
 * each time, so that the dev server shows a change of it.
 *
 * @throws RangeError if the template has a place that nothing fills.
 */
export function shell(page: ShellPage, template: string = readFileSync(TEMPLATE, "utf8")): Html {
  const places: Readonly<Record<string, Html>> = {
    lang: page.lang,
    policy: page.csp
      ? `<meta${attributes({ "http-equiv": "Content-Security-Policy", content: page.csp })}>`
      : "",
    title: escapeHtml(page.title === SITE_NAME ? SITE_NAME : `${page.title} · ${SITE_NAME}`),
    description: escapeHtml(page.description),
    root: escapeHtml(page.root),
    links: headLinks(page),
    boot: `<script>${page.bootScript}</script>`,
    styles: [
      ...page.fonts.map((path) => preloadFont(page.root + path)),
      ...page.styles.map((path) => `<link${attributes({ rel: "stylesheet", href: page.root + path })}>`),
    ].join("\n"),
    scripts: page.scripts
      .map((path) => `<script${attributes({ type: "module", src: page.root + path })}></script>`)
      .join("\n"),
    bodyClass: escapeHtml(page.bodyClass),
    body: page.chrome ? chrome(page, page.chrome) : page.body,
  };
  // One pass, so that braces in a page's own text are never taken for a place.
  const place = /^\{\{(\w+)\}\}\n|\{\{(\w+)\}\}/gm;
  return template
    .replace(/^<!-- biome-ignore.*-->\n/gm, "")
    .replace(place, (_, line?: string, inline?: string) => {
      const value = places[(line ?? inline)!];
      if (value === undefined)
        throw new RangeError(`index.html: nothing fills the place {{${line ?? inline}}}`);
      return line && value !== "" ? `${value}\n` : value;
    });
}

function headLinks(page: ShellPage): Html {
  return lines(
    page.noindex === true && '<meta name="robots" content="noindex">',
    page.canonical !== undefined && `<link${attributes({ rel: "canonical", href: page.canonical })}>`,
    ...(page.alternates ?? []).map(
      ({ lang, href }) => `<link${attributes({ rel: "alternate", hreflang: lang, href })}>`,
    ),
  );
}

/** Fonts are always asked for without credentials; a preload that says otherwise would fetch them twice. */
function preloadFont(href: string): Html {
  return `<link${attributes({ rel: "preload", as: "font", type: "font/woff2", href })} crossorigin>`;
}
