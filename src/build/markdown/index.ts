import { attrs } from "@mdit/plugin-attrs";
import MarkdownIt from "markdown-it";
import { callouts } from "./blocks/callout.ts";
import { code } from "./blocks/code.ts";
import { demo, print } from "./blocks/demo.ts";
import { identity, notation } from "./blocks/identity.ts";
import { answer, predict } from "./blocks/predict.ts";
import { symbols } from "./blocks/symbols.ts";
import { type BlockRules, blocks } from "./rules/blocks.ts";
import { footnotes } from "./rules/footnotes.ts";
import { glue } from "./rules/glue.ts";
import { headings } from "./rules/headings.ts";
import { lines } from "./rules/lines.ts";
import { links } from "./rules/links.ts";
import { skeleton } from "./rules/skeleton.ts";
import { stateLinks } from "./rules/state-links.ts";
import { tex } from "./rules/tex.ts";
import { unparsed } from "./rules/unparsed.ts";

/** Every kind of block a lesson may hold; a new one is a file of `blocks/` and an entry here. */
const BLOCKS: BlockRules = { demo, print, code, identity, notation, predict, answer, symbols, ...callouts };

/** The markdown of the lessons. The order matters where a rule says so. */
export function createMarkdown(): MarkdownIt {
  return new MarkdownIt({ html: false, linkify: false, typographer: false })
    .use(tex)
    .use(footnotes)
    .use(attrs, { rule: ["heading", "inline"], allowed: ["id", "class", "lang"] })
    .use(lines)
    .use(unparsed)
    .use(blocks, BLOCKS)
    .use(stateLinks)
    .use(links)
    .use(headings)
    .use(skeleton)
    .use(glue);
}
