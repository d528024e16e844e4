import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { type LessonEnv, lineOf } from "../env.ts";

/** Adds headings and displayed formulas to what both languages must share, and puts it in order. */
export function skeleton(md: MarkdownIt): void {
  md.core.ruler.push("skeleton", (state) => {
    const env: LessonEnv = state.env;
    gather(state.tokens, env);
    for (const { line, level, id } of env.headings) {
      env.skeleton.push({ line, sign: `heading ${"#".repeat(level)} {#${id}}` });
    }
    env.skeleton.sort((a, b) => a.line - b.line);
  });
}

function gather(tokens: readonly Token[], env: LessonEnv): void {
  for (const token of tokens) {
    if (token.type === "math_block") env.skeleton.push({ line: lineOf(token), sign: "displayed formula" });
    gather(token.children ?? [], env);
  }
}
