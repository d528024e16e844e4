/** The longest text that is looked at, for one parameter of a URL. */
export const MAX_TEXT = 8000;

/** A number of the URL notation: decimal point, optional exponent, nothing else; null where it is none. */
export function readNumber(text: string): number | null {
  if (!/^-?(\d+\.?\d*|\.\d+)(e[+-]?\d{1,3})?$/i.test(text)) return null;
  const value = Number(text);
  return Number.isFinite(value) ? value : null;
}

/** The shortest text that reads back as the same number. */
export function writeNumber(value: number): string {
  return String(Object.is(value, -0) ? 0 : value);
}

/** Rounds to a number of decimals; exact in the sense that the result prints with at most so many. */
export function roundTo(value: number, decimals: number): number {
  const rounded = Number(value.toFixed(Math.min(20, Math.max(0, decimals))));
  return Object.is(rounded, -0) ? 0 : rounded;
}

/** How many decimals a step has: 0.05 → 2. */
export function decimalsOf(step: number): number {
  const text = step.toFixed(10).replace(/0+$/, "");
  return text.includes(".") ? text.length - text.indexOf(".") - 1 : 0;
}

export function clamp(value: number, min: number, max: number): number {
  return Math.min(Math.max(value, min), max);
}

export function isNumberIn(value: unknown, min: number, max: number): value is number {
  return typeof value === "number" && Number.isFinite(value) && value >= min && value <= max;
}
