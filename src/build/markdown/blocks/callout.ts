import { block as template } from "../../templates/block.ts";
import { BLOCK_KINDS, type BlockKind } from "../../templates/types.ts";
import type { BlockRule, BlockRules } from "../rules/blocks.ts";

/** `::: definition Bézier curve {#def-bezier}`: a passage set apart, with words after its name. */
function callout(kind: BlockKind): BlockRule {
  return {
    form: `::: ${kind} words`,
    titled: true,
    read: (block, env) => env.skeleton.push({ line: block.line, sign: kind }),
    render: (block, env, tools) =>
      `${template({
        lang: env.lang,
        kind,
        title: tools.inline(block.title),
        id: block.id,
        html: tools.html(block.children),
      })}\n`,
  };
}

export const callouts: BlockRules = Object.fromEntries(BLOCK_KINDS.map((kind) => [kind, callout(kind)]));
