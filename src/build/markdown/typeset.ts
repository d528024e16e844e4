import katex from "katex";
import type { Lang } from "../../words/words.ts";
import type { LiveNumber } from "../tex/live-number.ts";
import { plainTex } from "../tex/say-tex.ts";
import { macros } from "./tex-macros.ts";

export type Typeset =
  | { readonly ok: true; readonly html: string }
  /** `line`: within the formula, from 0. */
  | { readonly ok: false; readonly message: string; readonly line: number };

/** Formulas set so far: a saved lesson only pays for those that changed. */
const done = new Map<string, Typeset>();

/** Sets a formula as HTML for the eyes and MathML for the ears. */
export function typeset(content: string, display: boolean, lang: Lang): Typeset {
  const key = `${lang}${display ? "$$" : "$"}${content}`;
  let result = done.get(key);
  if (!result) {
    result = run(content, display, lang);
    done.set(key, result);
  }
  return result;
}

/**
 * A formula whose symbols are marked (`tex`, made by `annotate`): set with its live numbers in their places. A mistake is
 * told in the author's own words (`source`).
 */
export function typesetMarked(
  marked: { readonly tex: string; readonly live: readonly LiveNumber[] },
  source: string,
  display: boolean,
  lang: Lang,
): Typeset {
  if (marked.tex === source) return typeset(source, display, lang);
  const plain = typeset(plainTex(source), display, lang);
  const result = plain.ok ? typeset(marked.tex, display, lang) : plain;
  if (!result.ok || !plain.ok) return result;
  // Who copies the formula gets it as it is written in books.
  const annotation = /<annotation.*?<\/annotation>/s;
  const clean = annotation.exec(plain.html)?.[0] ?? "";
  return {
    ok: true,
    html: fill(
      result.html.replace(annotation, () => clean),
      marked.live,
    ),
  };
}

/** Puts the numbers into their places: a box of fixed room for the eyes, a number for the ears. */
function fill(html: string, live: readonly LiveNumber[]): string {
  const eyes =
    /<span class="enclosing([^"]*)" data-live="(\d+)"><span class="mord text[^"]*">(?:<span class="mord[^"]*">)?@\d+@(?:<\/span>)?<\/span><\/span>/g;
  const filled = html
    .replace(eyes, (_, classes: string, k: string) => {
      const { source, digits, isPoint, text, signs, room } = live[Number(k)]!;
      return `<span class="live${isPoint ? " point" : ""} mord${classes}" data-live="${source}" data-digits="${digits}" data-room="${signs}" style="--room:${room}em">${text}</span>`;
    })
    .replace(/<mtext>@(\d+)@<\/mtext>/g, (_, k: string) => {
      const { source, digits, text } = live[Number(k)]!;
      return `<mn data-live="${source}" data-digits="${digits}">${text}</mn>`;
    });
  if (/@\d+@/.test(filled))
    throw new Error(`KaTeX has set the place of a live number in an unknown way: ${html}`);
  return filled;
}

function run(content: string, displayMode: boolean, lang: Lang): Typeset {
  try {
    const html = katex.renderToString(content, {
      displayMode,
      output: "htmlAndMathml",
      throwOnError: true,
      // Symbols are marked with data attributes; nothing else may pass.
      strict: (code) => (code === "htmlExtension" ? "ignore" : "error"),
      trust: ({ command }) => command === "\\htmlData",
      macros: macros(lang),
    });
    return { ok: true, html };
  } catch (error) {
    if (!(error instanceof Error)) throw error;
    const position = "position" in error && typeof error.position === "number" ? error.position : 0;
    return {
      ok: false,
      // KaTeX underlines the place with combining signs, which hides the very letters.
      message: error.message.replace(/^KaTeX parse error: /, "").replace(/\u0332/g, ""),
      line: content.slice(0, position).split("\n").length - 1,
    };
  }
}
