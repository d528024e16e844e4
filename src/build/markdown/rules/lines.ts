import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";

/**
 * Gives each piece of running text its line, so that a message can name it. Must come directly after
 * "inline": footnotes are moved to the end afterwards.
 */
export function lines(md: MarkdownIt): void {
  md.core.ruler.after("inline", "lines", (state) => {
    let line = 0;
    for (const token of state.tokens) {
      // Cells of a table have no place of their own, their rows have.
      line = token.map?.[0] ?? line;
      if (token.type === "inline") number(token.children ?? [], line, state.env);
    }
  });
}

function number(children: readonly Token[], first: number, env: { footnotes?: Footnotes }): void {
  let line = first;
  for (const child of children) {
    child.map = [line, line + 1];
    const words = env.footnotes?.list?.[child.meta?.id ?? -1];
    if (child.type === "footnote_ref" && words?.tokens) number(words.tokens, line, env);
    line +=
      child.type === "softbreak" || child.type === "hardbreak" ? 1 : child.content.split("\n").length - 1;
  }
}

interface Footnotes {
  readonly list?: readonly { readonly tokens?: Token[] }[];
}
