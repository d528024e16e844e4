import { formatNumber, formatPoint } from "../../words/numbers.ts";
import type { Lang } from "../../words/words.ts";

/** A live number in a formula: where it comes from, how many decimals it has, and how much room. */
export interface LiveNumber {
  /** `figure/path`. */
  readonly source: string;
  readonly digits: number;
  /** A point is set from its left, a number from its right. */
  readonly isPoint: boolean;
  /** The text at first. */
  readonly text: string;
  /** The widest text it is to hold: so many signs, and their width in em of the formula's font. */
  readonly signs: number;
  readonly room: number;
}

/** How wide the signs of a number are in KaTeX's main font, in em; digits are all alike. */
const WIDTHS: Readonly<Record<string, number>> = {
  ",": 0.278,
  ".": 0.278,
  ";": 0.278,
  " ": 0.25,
  "(": 0.389,
  ")": 0.389,
  "−": 0.778,
};

/**
 * Reads the picture of a number, `-0.00`: a place for the sign, so many digits, so many decimals. null if it is none.
 */
export function readPicture(text: string): { readonly digits: number; readonly widest: string } | null {
  const parts = /^(-?)(0+)(?:\.(0+))?$/.exec(text);
  return parts ? { digits: parts[3]?.length ?? 0, widest: text.replace("-", "−") } : null;
}

/** A number or point of a figure, as it stands in a formula of the given language. */
export function liveNumber(
  source: string,
  value: number | readonly number[],
  picture: { readonly digits: number; readonly widest: string },
  lang: Lang,
): LiveNumber {
  const { digits, widest } = picture;
  if (typeof value === "number") {
    return {
      source,
      digits,
      isPoint: false,
      text: formatNumber(value, lang, digits, true),
      signs: widest.length,
      room: widthOf(widest),
    };
  }
  const all = `(${value.map(() => widest).join("; ")})`;
  return {
    source,
    digits,
    isPoint: true,
    text: formatPoint(value, lang, digits, true),
    signs: all.length,
    room: widthOf(all),
  };
}

function widthOf(text: string): number {
  const sum = [...text].reduce((width, sign) => width + (WIDTHS[sign] ?? 0.5), 0);
  return Math.ceil(sum * 100) / 100;
}
