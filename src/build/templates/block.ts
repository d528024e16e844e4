import { attributes } from "./html.ts";
import type { BlockData, Html } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * A passage set apart: definition, theorem, note, … Its name stands in the first line. Notes, history and
 * additions move to the margin where there is room for one.
 */
export function block(data: BlockData): Html {
  const name = WORDS[data.lang].blocks[data.kind];
  const words = data.title ? ` <span class="block-words">(${data.title})</span>` : "";
  const head = `<p class="block-name"><strong>${name}</strong>${words}</p>`;
  // A note, but no landmark: a lesson has many of them.
  const role = data.kind === "note" || data.kind === "history" ? "note" : null;
  return `<div${attributes({ id: data.id, class: `block ${data.kind}`, role })}>
${head}
${data.html}
</div>`;
}
