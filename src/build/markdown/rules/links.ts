import type MarkdownIt from "markdown-it";
import type Token from "markdown-it/lib/token.mjs";
import { type LessonEnv, lineOf, report } from "../env.ts";
import { eachInline } from "./walk.ts";

/**
 * Links of the running text: `lesson:id#anchor` to another lesson, `#anchor` within this one, and whole
 * addresses of other sites. Their ends are checked when all lessons are known.
 */
export function links(md: MarkdownIt): void {
  md.core.ruler.push("lesson_links", (state) => {
    eachInline(state.tokens, (_, children) => {
      for (const token of children) if (token.type === "link_open") readLink(token, state.env);
    });
  });
}

function readLink(token: Token, env: LessonEnv): void {
  const line = lineOf(token);
  const href = decodeURI(token.attrGet("href") ?? "");
  const lesson = /^lesson:([^#/?]+)(?:#(.+))?$/.exec(href);
  if (lesson) {
    const [, id, anchor = null] = lesson;
    env.links.push({ line, lesson: id!, anchor });
    token.attrSet("href", `../${id}/${anchor === null ? "" : `#${anchor}`}`);
  } else if (href.startsWith("#") && href.length > 1) {
    env.links.push({ line, lesson: null, anchor: href.slice(1) });
  } else if (!/^https:\/\/|^mailto:|^demo:/.test(href)) {
    const form = 'write "lesson:id#anchor", "#anchor", "demo:figure-id?t=0.5" or an address with https://';
    report(env, line, `the link "${href}" leads nowhere that the build knows`, form);
  }
}
