import { tex as texPlugin } from "@mdit/plugin-tex";
import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { formula } from "../../templates/formula.ts";
import type { FormulaData } from "../../templates/types.ts";
import { annotate, type SymbolUse } from "../../tex/annotate.ts";
import { plainTex, sayTex } from "../../tex/say-tex.ts";
import { type FormulaMeta, type LessonEnv, lineOf, report } from "../env.ts";
import { texContext } from "../tex-context.ts";
import { typeset, typesetMarked } from "../typeset.ts";

/** `$…$` and `$$…$$`, set by KaTeX while the lesson is built; a formula that fails is a problem with its line. */
export function tex(md: MarkdownIt): void {
  md.use(texPlugin, { delimiters: "dollars", render: () => "" });
  md.renderer.rules.math_inline = (tokens, i, _options, env: LessonEnv) => set(tokens[i]!, false, env).html;
  md.renderer.rules.math_block = (tokens, i, _options, env: LessonEnv) => {
    const token = tokens[i]!;
    const { html, symbols } = set(token, true, env);
    const { id = null, check = null, notation = false } = (token.meta ?? {}) as FormulaMeta;
    env.formulas.push({ line: lineOf(token), check, notation });
    return `${formula({ lang: env.lang, id, html, words: "", symbols: listed(symbols, env) })}\n`;
  };
  // Before "text_join": until then a "\\$" of the author's is told apart from one that was left over.
  md.core.ruler.before("text_join", "stray_tex", (state) => {
    for (const token of state.tokens) checkStray(token.children ?? [], state.env);
  });
}

function set(
  token: Token,
  display: boolean,
  env: LessonEnv,
): { readonly html: string; readonly symbols: readonly SymbolUse[] } {
  const marked = annotate(token.content, texContext(token, env));
  const result = typesetMarked(marked, token.content, display, env.lang);
  if (display) checkEnd(token, env);
  // What follows "$$" on its own line begins on the next one.
  const below = display && /^[^$]*\$\$\s*$/.test(env.source[lineOf(token) - 1] ?? "");
  const first = lineOf(token) + (below ? 1 : 0);
  if (!result.ok) {
    report(env, first + result.line, `TeX: ${result.message}`, `mend the formula: ${shorten(token.content)}`);
    return { html: "", symbols: [] };
  }
  for (const { message, remedy } of marked.problems) report(env, first, `TeX: ${message}`, remedy);
  return { html: result.html, symbols: marked.symbols };
}

/** The symbols of a formula as its list shows them: each once. */
function listed(symbols: readonly SymbolUse[], env: LessonEnv): FormulaData["symbols"] {
  const all = symbols.map(({ tex, tie, index, entry, known = null, value = null }) => {
    const own = plainTex(tex).trim();
    // Where there is but a number, the list names what it is the number of.
    const glyph = own === "" && known && tie ? typeset(marked(tie, index, known), false, env.lang) : null;
    const html = glyph?.ok ? glyph.html : null;
    return { say: sayTex(own || (known ?? ""), env.lang), tie, entry, value, glyph: html };
  });
  const same = (a: (typeof all)[number], b: (typeof all)[number]) => a.say === b.say && a.tie === b.tie;
  return all.filter((one, i) => all.findIndex((other) => same(one, other)) === i);
}

function marked(tie: string, index: number | null, tex: string): string {
  return `\\htmlData{tie=${tie}${index === null ? "" : `,index=${index % 10}`}}{${tex}}`;
}

/** The parser takes everything up to the end of the lesson for a formula that is not closed. */
function checkEnd(token: Token, env: LessonEnv): void {
  const last = env.source[(token.map?.[1] ?? 0) - 1] ?? "";
  if (!/\$\$\s*$/.test(last)) {
    report(env, lineOf(token), 'this "$$" is not closed', 'end the formula with "$$" at the end of a line');
  }
}

function shorten(content: string): string {
  const text = content.replace(/\s+/g, " ").trim();
  return text.length > 70 ? `${text.slice(0, 69)}…` : text;
}

/** A formula whose end was not found, or display signs within a line, stay in the text as they are. */
function checkStray(children: readonly Token[], env: LessonEnv): void {
  for (const child of children) {
    if (child.type !== "text" || !child.content.includes("$")) continue;
    report(
      env,
      lineOf(child),
      `a "$" that belongs to no formula: ${shorten(child.content)}`,
      'close the formula in the same paragraph, with no space before its last "$" and no digit after it; put "$$" on lines of their own; write "\\$" for the sign itself',
    );
  }
}
