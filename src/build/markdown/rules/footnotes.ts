import { footnote } from "@mdit/plugin-footnote";
import type MarkdownIt from "markdown-it";
import type { LessonEnv } from "../env.ts";

const WORDS = {
  de: { notes: "Fußnoten", note: "Fußnote", back: "Zurück zum Text" },
  en: { notes: "Footnotes", note: "Footnote", back: "Back to the text" },
} as const;

/** `[^1]` and `[^1]: …`, or `^[…]` in place: notes at the end of the lesson, with names for those who hear it. */
export function footnotes(md: MarkdownIt): void {
  md.use(footnote);
  const { rules } = md.renderer;
  rules.footnote_ref = (tokens, i, _options, env: LessonEnv) => {
    const [id, sub] = idsOf(tokens[i]!.meta);
    const label = `${WORDS[env.lang].note} ${id}`;
    return `<sup class="footnote-ref"><a id="footnote-ref-${id}${sub}" href="#footnote-${id}" aria-label="${label}">${id}</a></sup>`;
  };
  rules.footnote_block_open = (_tokens, _i, _options, env: LessonEnv) =>
    `<section class="footnotes" aria-label="${WORDS[env.lang].notes}">\n<ol>\n`;
  rules.footnote_block_close = () => "</ol>\n</section>\n";
  rules.footnote_open = (tokens, i) => `<li id="footnote-${idsOf(tokens[i]!.meta)[0]}">`;
  rules.footnote_anchor = (tokens, i, _options, env: LessonEnv) => {
    const [id, sub] = idsOf(tokens[i]!.meta);
    return ` <a class="footnote-back" href="#footnote-ref-${id}${sub}" aria-label="${WORDS[env.lang].back}">↩\uFE0E</a>`;
  };
}

/** The note's number, and what tells its second and third mention apart. */
function idsOf({ id, subId = 0 }: { id: number; subId?: number }): [number, string] {
  return [id + 1, subId > 0 ? `-${subId}` : ""];
}
