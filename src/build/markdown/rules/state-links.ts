import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { choices } from "../../problem.ts";
import { stateLink } from "../../templates/state-link.ts";
import { type LessonEnv, lineOf, report } from "../env.ts";
import { readState } from "../read-state.ts";
import { eachInline } from "./walk.ts";

/**
 * `[[words]](demo:figure-id?t=0.5)`: words that put a figure of the lesson into a state. A named state
 * (`?state=half`) is written out, so that the page's address says what it means. Must come after the blocks
 * are folded, since a link may stand before its figure.
 */
export function stateLinks(md: MarkdownIt): void {
  md.core.ruler.push("state_links", (state) => {
    eachInline(state.tokens, (inline, children) => {
      if (children.some((token) => token.type === "link_open" && isDemo(token))) {
        inline.children = gather(children, state.env);
      }
    });
  });
  md.renderer.rules.state_link = (tokens, i, options, env, self) => {
    const token = tokens[i]!;
    const html = self.renderInline(token.children ?? [], options, env);
    return stateLink({ lang: env.lang, figure: token.meta.figure, query: token.meta.query, html });
  };
}

function isDemo(token: Token): boolean {
  return (token.attrGet("href") ?? "").startsWith("demo:");
}

/** Makes each link to a demo one token, whose words are its children. */
function gather(children: readonly Token[], env: LessonEnv): Token[] {
  const result: Token[] = [];
  for (let i = 0; i < children.length; i++) {
    const open = children[i]!;
    if (open.type !== "link_open" || !isDemo(open)) {
      result.push(open);
      continue;
    }
    const close = children.findIndex((token, k) => k > i && token.type === "link_close");
    const words = children.slice(i + 1, close);
    i = close;
    result.push(...readLink(open, words, env));
  }
  return result;
}

function readLink(open: Token, words: Token[], env: LessonEnv): Token[] {
  const line = lineOf(open);
  const [figureId = "", query = ""] = decodeURI(open.attrGet("href") ?? "")
    .slice("demo:".length)
    .split("?", 2);
  const [first, last] = [words[0], words.at(-1)];
  if (
    first?.type !== "text" ||
    last?.type !== "text" ||
    !/^\[/.test(first.content) ||
    !/\]$/.test(last.content)
  ) {
    report(
      env,
      line,
      "a link to a figure's state has double brackets",
      "write [[words]](demo:figure-id?t=0.5)",
    );
    return words;
  }
  first.content = first.content.slice(1);
  last.content = last.content.slice(0, -1);
  const figure = env.figures.find(({ id }) => id === figureId);
  if (!figure) {
    const ids = env.figures.map(({ id }) => id);
    report(env, line, `no figure "${figureId}" in this lesson`, choices(figureId, ids));
    return words;
  }
  const demo = env.demos.get(figure.demo);
  if (!demo) return words;
  const state = readState(demo, query);
  for (const { message, remedy } of state.problems)
    report(env, line, `figure "${figureId}": ${message}`, remedy);
  env.stateLinks.push({ line, figure: figureId, query: state.query, patch: state.patch });
  const token = new (open.constructor as new (type: string, tag: string, nesting: 0) => Token)(
    "state_link",
    "a",
    0,
  );
  token.children = words;
  token.map = open.map;
  token.meta = { figure: figureId, query: state.query };
  return [token];
}
