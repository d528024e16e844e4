import { sourceLines } from "../../source-lines.ts";
import { code as template } from "../../templates/code.ts";
import { escapeHtml } from "../../templates/html.ts";
import { report } from "../env.ts";
import type { BlockRule } from "../rules/blocks.ts";

/**
 * `::: code src/math/de-casteljau.ts deCasteljau`: the very lines of the program, either the body of the
 * function of that name or what stands between `// #region name` and `// #endregion`.
 */
export const code: BlockRule = {
  form: "::: code <file> <function or region>",
  read: (block, env) => {
    env.skeleton.push({ line: block.line, sign: `code ${block.args}` });
    const [file = "", name = ""] = block.args.split(/\s+/);
    const source = env.readSource(file);
    if (!file || !name) {
      report(env, block.line, "file or name is missing", `write ${code.form}`);
    } else if (source === null) {
      report(env, block.line, `there is no file "${file}"`, "give a path from the project's root");
    } else {
      const lines = sourceLines(source, name);
      if (lines !== null) return lines;
      report(
        env,
        block.line,
        `neither a function nor a region "${name}" in ${file}`,
        'name an exported or inner function, or mark lines with "// #region name" and "// #endregion"',
      );
    }
    return [];
  },
  render: (block, env, _tools, data) =>
    `${template({
      lang: env.lang,
      html: escapeHtml((data as readonly string[]).join("\n")),
      source: block.args.split(/\s+/)[0]!,
    })}\n`,
};
