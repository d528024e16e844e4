import type { Label } from "../scene/label.ts";
import { formatNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import type { TextRun } from "./primitives.ts";
import { type Font, SIZE } from "./sizes.ts";
import { textWidth } from "./text-width.ts";

/** A label set in runs from the start of its baseline, with its extent in pixels. */
export interface SetText {
  readonly runs: readonly TextRun[];
  readonly width: number;
  /** Above and below the baseline, both positive. */
  readonly ascent: number;
  readonly descent: number;
}

/** Sets a label: base, primes, sub above sup, arguments in brackets. Size in pixels, default 17. */
export function setLabel(label: Label, lang: Lang, size?: number): SetText {
  const words = label.style === "text";
  const full = size ?? (words ? SIZE.words : SIZE.label);
  const small = Math.round((full * SIZE.script) / SIZE.label);
  const runs: TextRun[] = [];
  const put = (text: string, runSize: number, from: number, dy: number): number => {
    let x = from;
    for (const [piece, font] of pieces(text)) {
      runs.push({ text: piece, font, size: runSize, dx: x, dy });
      x += textWidth(piece, font, runSize);
    }
    return x;
  };
  const base = typeof label.base === "string" ? label.base : label.base[lang];
  let x = 0;
  if (words) {
    runs.push({ text: base, font: "text", size: full, dx: 0, dy: 0 });
    x = textWidth(base, "text", full);
  } else {
    x = put(base, full, 0, 0);
  }
  const sup = "′".repeat(label.prime ?? 0) + (label.sup ?? "");
  const afterSub = label.sub ? put(label.sub, small, x, full * 0.22) : x;
  const afterSup = sup ? put(sup, small, x + full * 0.04, full * -0.4) : x;
  x = Math.max(afterSub, afterSup);
  if (label.args) x = put(`(${list(label.args, lang)})`, full, x, 0);
  return {
    runs,
    width: x,
    ascent: Math.max(ascent(base), label.args ? 0.75 : 0) * full + (sup ? full * 0.2 : 0),
    descent: Math.max(label.args ? 0.25 : descent(base), label.sub ? 0.28 : 0) * full,
  };
}

/** In German the comma belongs to the numbers, so that they stand apart by a semicolon. */
function list(args: readonly (string | number)[], lang: Lang): string {
  const between = lang === "de" && args.some((arg) => typeof arg === "number") ? "; " : ", ";
  return args.map((arg) => (typeof arg === "number" ? formatNumber(arg, lang) : arg)).join(between);
}

/** Letters in the mathematical italic, all else upright; a hyphen becomes the real minus sign. */
function pieces(text: string): [string, Font][] {
  const found: [string, Font][] = [];
  for (const char of text.replaceAll("-", "\u2212")) {
    const font = /[A-Za-z\u03b1-\u03c9\u03d1\u03d5\u03f5]/.test(char) ? "math" : "main";
    const last = found.at(-1);
    if (last?.[1] === font) last[0] += char;
    else found.push([char, font]);
  }
  return found;
}

// Shares of the size; what is not listed is taken for the usual case.
function ascent(text: string): number {
  return /^[acegmnopqrsuvwxyzαγεηικμνοπρστυχω .,;:]*$/.test(text) ? 0.46 : 0.73;
}

function descent(text: string): number {
  return /[fgjpqy()[\]{}|,;Qβγζημξρφχψ]/.test(text) ? 0.22 : 0.02;
}
