import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { section } from "../../templates/section.ts";
import { addAnchor, type LessonEnv, lineOf, report } from "../env.ts";

/**
 * Headings carry explicit ids, the same in both languages, so that a link survives a better wording; an h2
 * with all that follows becomes a section. Must come after the blocks are folded.
 */
export function headings(md: MarkdownIt): void {
  md.core.ruler.push("headings", (state) => {
    const env: LessonEnv = state.env;
    for (const [i, token] of state.tokens.entries()) {
      if (token.type === "heading_open") readHeading(token, state.tokens[i + 1]!, env, md);
    }
    state.tokens = sections(state.tokens, state.Token);
  });
  md.renderer.rules.section = (tokens, i, options, env, self) => {
    const children = tokens[i]!.children!;
    const html = self.render(children, options, env);
    return `${section({ html, ...measure(html) })}\n`;
  };
}

function readHeading(open: Token, inline: Token, env: LessonEnv, md: MarkdownIt): void {
  const line = lineOf(open);
  const level = Number(open.tag.slice(1));
  const id = open.attrGet("id");
  if (level === 1 || level > 4) {
    report(
      env,
      line,
      `a heading of level ${level}`,
      "the title stands in the front matter; use ##, ### or ####",
    );
  }
  if (id === null) {
    report(
      env,
      line,
      `the heading "${inline.content}" has no id`,
      "end it with {#an-id}, the same in both languages",
    );
    return;
  }
  addAnchor(env, id, line);
  const html = md.renderer.renderInline(inline.children ?? [], md.options, env);
  env.headings.push({ id, line, level, html });
}

function sections(tokens: readonly Token[], TokenClass: typeof Token): Token[] {
  const result: Token[] = [];
  let current: Token | null = null;
  for (const token of tokens) {
    if (token.type === "heading_open" && token.tag === "h2") {
      current = new TokenClass("section", "section", 0);
      current.children = [];
      current.map = token.map;
      result.push(current);
    }
    if (token.type === "footnote_block_open") current = null;
    if (current) current.children!.push(token);
    else result.push(token);
  }
  return result;
}

/** What a section's height is guessed from. */
function measure(html: string): { formulas: number; figures: number; characters: number } {
  const count = (sign: string) => html.split(sign).length - 1;
  const text = html
    .replace(/<(svg|math|pre)[\s>].*?<\/\1>/gs, "")
    .replace(/<span class="katex-html".*?<\/span>(?=[^<]*<\/?[a-z]*[^s])/gs, "")
    .replace(/<[^>]*>/g, "");
  return { formulas: count('<span class="katex">'), figures: count("<curve-demo"), characters: text.length };
}
