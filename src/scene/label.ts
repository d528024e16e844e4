import type { Words } from "../words/words.ts";

/**
 * A label as data, so that canvas, SVG and TikZ can each set it in their own way:
 * base′_sub^sup(args), for instance p′(0.4), B_1^3(t), c_2.
 *
 * `style: "math"` (the default) sets base and letters of sub and sup in the mathematical italic, digits
 * upright; `"text"` is plain words. Numbers among `args` are written in the reader's locale.
 */
export interface Label {
  readonly base: string | Words;
  readonly sub?: string;
  readonly sup?: string;
  readonly prime?: 1 | 2 | 3;
  readonly args?: readonly (string | number)[];
  readonly style?: "math" | "text";
}

/** A mathematical symbol, for instance `symbol("c", 0)` for c₀. */
export function symbol(base: string, sub?: string | number, sup?: string | number): Label {
  return {
    base,
    ...(sub === undefined ? {} : { sub: String(sub) }),
    ...(sup === undefined ? {} : { sup: String(sup) }),
  };
}

/** Plain words in both languages. */
export function wording(base: Words): Label {
  return { base, style: "text" };
}
