import type { Lang } from "./words.ts";

const MINUS = "\u2212";
const LOCALE: Record<Lang, string> = { de: "de-DE", en: "en-GB" };
const formats = new Map<string, Intl.NumberFormat>();

function format(lang: Lang, digits: number, fixed: boolean): Intl.NumberFormat {
  const id = `${lang}${digits}${fixed}`;
  let found = formats.get(id);
  if (!found) {
    found = new Intl.NumberFormat(LOCALE[lang], {
      useGrouping: false,
      minimumFractionDigits: fixed ? digits : 0,
      maximumFractionDigits: digits,
    });
    formats.set(id, found);
  }
  return found;
}

/**
 * A number as it is read in the given language: decimal comma in German, decimal point in English, a real
 * minus sign in both, never "−0". `fixed` keeps trailing zeros, so that a readout does not change its width.
 * A value that is not finite is shown as "–".
 */
export function formatNumber(value: number, lang: Lang, digits = 2, fixed = false): string {
  if (!Number.isFinite(value)) return "–";
  const text = format(lang, digits, fixed).format(value);
  if (!text.startsWith("-")) return text;
  return /[1-9]/.test(text) ? MINUS + text.slice(1) : text.slice(1);
}

/** A point as it is read: (0,5; 2) in German, where the comma is taken, (0.5, 2) in English. */
export function formatPoint(point: readonly number[], lang: Lang, digits = 2, fixed = false): string {
  const parts = point.map((coordinate) => formatNumber(coordinate, lang, digits, fixed));
  return `(${parts.join(lang === "de" ? "; " : ", ")})`;
}

/**
 * The number that a person typed, or null. Comma and point both count as the decimal sign, in either
 * language; a real minus sign and surrounding space are fine; anything else is not a number.
 */
export function parseNumber(text: string): number | null {
  const plain = text.trim().replace(MINUS, "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d{1,3})?$/i.test(plain) ? Number(plain) : null;
}
