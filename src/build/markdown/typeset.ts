import katex from "katex";
import type { Lang } from "../../words/words.ts";
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

function run(content: string, displayMode: boolean, lang: Lang): Typeset {
  try {
    const html = katex.renderToString(content, {
      displayMode,
      output: "htmlAndMathml",
      throwOnError: true,
      strict: "error",
      trust: false,
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
