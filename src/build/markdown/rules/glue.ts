import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { eachInline } from "./walk.ts";

/** Longer formulas must be free to break. */
const SHORT = 24;

/**
 * Keeps a short formula and the punctuation that touches it on one line: browsers allow a break before and
 * after every inline box, so that a comma could begin the next line.
 */
export function glue(md: MarkdownIt): void {
  md.core.ruler.push("glue", (state) => {
    eachInline(state.tokens, (inline, children) => {
      inline.children = glued(children, state.Token);
    });
  });
}

function glued(children: readonly Token[], TokenClass: typeof Token): Token[] {
  const result: Token[] = [];
  for (const [i, token] of children.entries()) {
    if (token.children && token.type !== "image") token.children = glued(token.children, TokenClass);
    const short = token.type === "math_inline" && token.content.length <= SHORT;
    const before = short ? take(result.at(-1), /[^\s]+$/) : "";
    const after = short ? take(children[i + 1], /^[^\s]+/) : "";
    if (!before && !after) {
      result.push(token);
      continue;
    }
    const open = new TokenClass("glue_open", "span", 1);
    open.attrs = [["class", "glue"]];
    result.push(
      open,
      text(before, TokenClass),
      token,
      text(after, TokenClass),
      new TokenClass("glue_close", "span", -1),
    );
  }
  return result;
}

/** Takes what touches the formula away from the neighbouring text. */
function take(token: Token | undefined, pattern: RegExp): string {
  if (token?.type !== "text") return "";
  const found = pattern.exec(token.content)?.[0] ?? "";
  token.content = token.content.replace(pattern, "");
  return found;
}

function text(content: string, TokenClass: typeof Token): Token {
  const token = new TokenClass("text", "", 0);
  token.content = content;
  return token;
}
