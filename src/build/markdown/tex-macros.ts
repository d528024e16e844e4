import type { Lang } from "../../words/words.ts";

/** What KaTeX hands to a macro that is a function. */
interface MacroContext {
  consumeArg(): { readonly tokens: readonly { readonly text: string }[] };
}

/**
 * The macros of the lessons, fresh for each formula since KaTeX writes into the object.
 *
 * `\num{0.5}` writes a number in the reader's language, so that both languages can share a formula.
 */
export function macros(lang: Lang): Record<string, string | ((context: MacroContext) => string)> {
  return {
    "\\R": "\\mathbb{R}",
    "\\N": "\\mathbb{N}",
    "\\dd": "\\mathrm{d}",
    "\\abs": "\\left|#1\\right|",
    "\\norm": "\\left\\lVert#1\\right\\rVert",
    "\\num": (context) => {
      // The tokens of an argument come last first.
      const text = [...context.consumeArg().tokens].reverse().map((token) => token.text);
      return text.join("").replace(".", lang === "de" ? "{,}" : ".");
    },
  };
}
