import { formatNumber, formatPoint } from "./numbers.ts";
import type { Lang } from "./words.ts";

const formats = {
  de: new Intl.ListFormat("de", { type: "conjunction" }),
  en: new Intl.ListFormat("en-GB", { type: "conjunction" }),
};

/** Words in a row: "a, b und c", "a, b and c". */
export function formatList(words: readonly string[], lang: Lang): string {
  return formats[lang].format(words);
}

/** Points in a row: "(0; 0), (1; 2) und (4; 0)". */
export function formatPoints(points: readonly (readonly number[])[], lang: Lang): string {
  return formatList(
    points.map((point) => formatPoint(point, lang)),
    lang,
  );
}

/** Numbers in a row; in German, where the comma is taken, with semicolons: "0,25; 0,5; 0,25". */
export function formatNumbers(values: readonly number[], lang: Lang, digits = 2): string {
  return values.map((value) => formatNumber(value, lang, digits)).join(lang === "de" ? "; " : ", ");
}
