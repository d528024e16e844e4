import { changed, initialState } from "../../../demo/state.ts";
import { choices } from "../../problem.ts";
import { figure } from "../../templates/figure.ts";
import type { FigureData } from "../../templates/types.ts";
import { report } from "../env.ts";
import { readEntries } from "../read-state.ts";
import type { BlockRule } from "../rules/blocks.ts";

/** Attributes that speak to the figure's frame, with what they may be. */
const FRAME: Readonly<Record<string, RegExp>> = { controls: /^(full|compact|none)$/, autoplay: /^1$/ };

/** `::: demo bezier-curve {#fig-curve t=0.25}`: a demo, its state, and the caption as the block's text. */
export const demo: BlockRule = {
  form: "::: demo <demo-id> {#figure-id t=0.25}",
  read: (block, env) => {
    const found = env.demos.get(block.args);
    const id = block.id ?? "";
    // Even a figure that cannot be shown has its place, so that one mistake is told once.
    if (!found) {
      env.figures.push({ id, line: block.line, demo: block.args, own: null });
      report(env, block.line, `unknown demo "${block.args}"`, choices(block.args, [...env.demos.keys()]));
      env.skeleton.push({ line: block.line, sign: `demo ${block.args} #${id}` });
      return null;
    }
    if (block.id === null)
      report(env, block.line, "the figure has no id", "write {#figure-id} behind the demo");
    const attributes = [...block.attributes];
    for (const [name, value] of attributes) {
      if (FRAME[name] && !FRAME[name].test(value)) {
        report(env, block.line, `${name}=${value} cannot be read`, `it must match ${FRAME[name].source}`);
      }
    }
    const read = readEntries(
      found,
      attributes.filter(([name]) => !FRAME[name]),
    );
    for (const { message, remedy } of read.problems) report(env, block.line, message, remedy);
    const own = changed(found, initialState(found), read.patch);
    env.figures.push({ id, line: block.line, demo: block.args, own });
    env.skeleton.push({ line: block.line, sign: `demo ${found.id} #${id} ${read.query}`.trim() });
    if (block.children.every((child) => child.type === "lesson_block")) {
      report(env, block.line, `the figure "${id}" has no caption`, "say below ::: demo what is to be seen");
    }
    const data: Omit<FigureData, "caption" | "printCaption"> = {
      id,
      demo: found.id,
      lang: env.lang,
      attributes: Object.fromEntries(attributes),
      ...env.still(found, own, env.lang),
    };
    return data;
  },
  render: (block, env, tools, data) => {
    if (data === null) return "";
    const given = data as Omit<FigureData, "caption" | "printCaption">;
    const guess = env.guesses.get(given.id);
    const isPrint = (token: (typeof block.children)[number]) => token.meta?.block?.name === "print";
    return `${figure({
      ...given,
      attributes: { ...given.attributes, ...(guess === undefined ? {} : { "data-guess": guess }) },
      caption: tools.html(block.children.filter((token) => !isPrint(token))),
      printCaption: tools.html(block.children.filter(isPrint)),
    })}\n`;
  },
};

/** `::: print` inside a demo: the caption on paper, where nothing can be dragged. */
export const print: BlockRule = {
  form: "::: print",
  inside: "demo",
  read: () => null,
  render: (block, _env, tools) => tools.html(block.children),
};
