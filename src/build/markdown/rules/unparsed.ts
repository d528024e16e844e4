import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { type LessonEnv, lineOf, report } from "../env.ts";

/** Notation that was meant, but not understood: it would stand in the page as it was typed. */
const LEFTOVERS: readonly (readonly [RegExp, string, string])[] = [
  [
    /\]\((demo|lesson):/,
    "a link that was not understood",
    "no spaces in its target; write %20, or quote nothing",
  ],
  [/^:::/, '":::" within a paragraph', "put it on a line of its own, unindented"],
  [/<\/?[a-z][a-z0-9-]*[\s/>]/i, "markup", "HTML is not read; use markdown, or \\< for the sign"],
  [/\{[#.][^}]*\}/, "braces with an id that belong to nothing", "ids stand at headings and blocks"],
  [/!\[/, "an image", "pictures are demos; use ::: demo"],
];

/** Must come before "text_join": until then a sign that the author escaped is told apart. */
export function unparsed(md: MarkdownIt): void {
  md.core.ruler.before("text_join", "unparsed", (state) => {
    for (const token of state.tokens) check(token.children ?? [], state.env);
  });
}

function check(children: readonly Token[], env: LessonEnv): void {
  for (const child of children) {
    const text = child.type === "image" ? "![" : child.type === "text" ? child.content : "";
    const found = LEFTOVERS.find(([pattern]) => pattern.test(text));
    if (found) report(env, lineOf(child), `${found[1]}: ${child.content.slice(0, 60)}`, found[2]);
  }
}
