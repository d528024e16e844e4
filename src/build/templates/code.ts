import { escapeHtml } from "./html.ts";
import type { CodeData, Html } from "./types.ts";
import { WORDS } from "./words.ts";

/** Lines of the program that the course itself runs, and where they stand. */
export function code(data: CodeData): Html {
  const source = data.source
    ? `<figcaption>${escapeHtml(WORDS[data.lang].codeFrom(data.source))}</figcaption>`
    : "";
  const label = escapeHtml(WORDS[data.lang].code);
  return `<figure class="code"><pre data-label="${label}"><code>${data.html}</code></pre>${source}</figure>`;
}
