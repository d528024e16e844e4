import type Token from "markdown-it/lib/token.mjs";
import { choices } from "../../problem.ts";
import { bareTex } from "../../tex/say-tex.ts";
import type { LessonEnv } from "../env.ts";
import { type FormulaMeta, lineOf, report } from "../env.ts";
import type { Block, BlockRule } from "../rules/blocks.ts";

/**
 * `::: identity <check-id> {#eq-id figure=fig}`: one displayed formula, proved by a check of `src/identities`. The check
 * knows the formula that it was written for: whoever changes the one must look at the other.
 */
export const identity: BlockRule = {
  form: "::: identity <check-id> {#eq-id}",
  read: (block, env) => {
    env.skeleton.push({ line: block.line, sign: `identity ${block.args} #${block.id ?? ""}` });
    const formula = onlyFormula(block, env);
    const written = env.identities.get(block.args);
    if (written === undefined) {
      report(env, block.line, `no check "${block.args}"`, choices(block.args, [...env.identities.keys()]));
    } else if (formula && bareTex(formula.content) !== bareTex(written)) {
      const line = lineOf(formula);
      const message = `this is not the formula of the check "${block.args}", which is: ${written}`;
      report(env, line, message, "mend the formula, or the check and its formula in src/identities");
    }
    mark(block, env, formula, { check: block.args });
    return null;
  },
  render: (block, _env, tools) => tools.html(block.children),
};

/** `::: notation {#eq-id figure=fig}`: one displayed formula that states nothing that could be computed. */
export const notation: BlockRule = {
  form: "::: notation {#eq-id}",
  read: (block, env) => {
    env.skeleton.push({ line: block.line, sign: `notation #${block.id ?? ""}` });
    mark(block, env, onlyFormula(block, env), { notation: true });
    return null;
  },
  render: (block, _env, tools) => tools.html(block.children),
};

function onlyFormula(block: Block, env: LessonEnv): Token | null {
  const [formula, ...more] = block.children;
  if (formula?.type === "math_block" && more.length === 0) return formula;
  report(
    env,
    block.line,
    `"${block.name}" holds something else than one formula`,
    "write $$ … $$ in it, no more",
  );
  return null;
}

/** Hands the formula what the block says of it. */
function mark(block: Block, env: LessonEnv, formula: Token | null, what: FormulaMeta): void {
  const figure = block.attributes.get("figure");
  const other = [...block.attributes.keys()].find((name) => name !== "figure");
  if (other !== undefined) report(env, block.line, `"${block.name}" has no "${other}"`, "there is: figure");
  if (formula) formula.meta = { ...what, id: block.id, figure } satisfies FormulaMeta;
}
