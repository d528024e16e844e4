import type Token from "markdown-it/lib/token.mjs";

/** Calls `visit` for every list of inline tokens, whatever blocks they stand in, in the order of the text. */
export function eachInline(
  tokens: readonly Token[],
  visit: (inline: Token, children: Token[]) => void,
): void {
  for (const token of tokens) {
    if (token.type === "inline") visit(token, token.children ?? []);
    else if (token.children) eachInline(token.children, visit);
    const title: Token | null = token.meta?.block?.title ?? null;
    if (title) visit(title, title.children ?? []);
  }
}
