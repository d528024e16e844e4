import Token from "markdown-it/lib/token.mjs";
import { choices } from "../../problem.ts";
import { symbols as template } from "../../templates/symbols.ts";
import { readPattern } from "../../tex/symbol-pattern.ts";
import { tieName } from "../../tex/tie-name.ts";
import { type LessonEnv, lineOf, report } from "../env.ts";
import type { Block, BlockRule } from "../rules/blocks.ts";
import { namesOf } from "../tex-context.ts";

interface Entry {
  readonly number: number;
  readonly symbol: Token;
  readonly meaning: Token;
}

/**
 * `::: symbols {#symbols}`: the symbols of the lesson, a list of lines "$c_i$ `points.i`: control point". Every such symbol
 * in a formula of the lesson tells its meaning; with a name behind it, it is tied to that mark, handle or parameter of
 * its figure.
 */
export const symbols: BlockRule = {
  form: "::: symbols {#symbols}",
  read: (block, env) => {
    const entries: Entry[] = [];
    if (env.glossary.length > 0) report(env, block.line, "a second list of symbols", "put both into one");
    for (const inline of inlines(block.children)) {
      const parts = readEntry(inline);
      if (!parts) {
        const form = "write - $c_i$ `points.i`: meaning, or - $n$: meaning";
        report(env, lineOf(inline), `cannot read the symbol "${inline.content.slice(0, 40)}"`, form);
        continue;
      }
      const number = env.glossary.length + 1;
      env.glossary.push({ number, pattern: readPattern(parts.symbol.content), tie: parts.tie });
      entries.push({ number, symbol: parts.symbol, meaning: parts.meaning });
    }
    const list = env.glossary.map(({ pattern, tie }) => `${pattern.tex} ${tie ?? ""}`.trim());
    env.skeleton.push({ line: block.line, sign: `symbols ${list.join(", ")}` });
    return entries;
  },
  render: (block, env, tools, data) => {
    checkTies(block, env);
    return `${template({
      lang: env.lang,
      id: block.id,
      entries: (data as Entry[]).map(({ number, symbol, meaning }) => ({
        number,
        symbol: tools.inline(Object.assign(new Token("inline", "", 0), { children: [symbol] })),
        meaning: tools.inline(meaning),
      })),
    })}\n`;
  },
};

function inlines(tokens: readonly Token[]): Token[] {
  return tokens.flatMap((token) => (token.type === "inline" ? [token] : inlines(token.children ?? [])));
}

/** The formula, the name in backquotes if there is one, and after the colon the meaning. */
function readEntry(inline: Token): { symbol: Token; tie: string | null; meaning: Token } | null {
  const children = (inline.children ?? []).filter((token) => token.type !== "text" || token.content !== "");
  const symbol = children.shift();
  if (symbol?.type !== "math_inline") return null;
  if (children[0]?.type === "text" && children[0].content.trim() === "") children.shift();
  const tie = children[0]?.type === "code_inline" ? children.shift()!.content.trim() : null;
  const text = children[0];
  if (text?.type !== "text" || !/^:\s*\S/.test(text.content)) return null;
  text.content = text.content.replace(/^:\s*/, "");
  inline.children = children;
  return { symbol, tie, meaning: inline };
}

/** A name that no figure of the lesson has would tie nothing, and nobody would see it. */
function checkTies(block: Block, env: LessonEnv): void {
  const figures = env.figures.flatMap(({ id }) => namesOf(id, env) ?? []);
  for (const { pattern, tie } of env.glossary) {
    if (tie === null) continue;
    const letters = new Map(tie.split(".").flatMap((part) => (/^[ijkr]$/.test(part) ? [[part, part]] : [])));
    if (figures.some((names) => tieName(tie, letters, names) !== null)) continue;
    const known = [
      ...new Set(
        figures.flatMap(({ names }) => [...names].flatMap(([name, { seen }]) => (seen ? name : []))),
      ),
    ];
    const message = `no figure of the lesson shows "${tie}", to which ${pattern.tex} is tied`;
    report(env, block.line, message, choices(tie, known));
  }
}
