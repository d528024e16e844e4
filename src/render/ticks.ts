import type { Interval } from "../scene/view.ts";

/** The places where an axis has its numbers, and the decimals that tell them apart. */
export interface Ticks {
  readonly step: number;
  readonly values: readonly number[];
  readonly digits: number;
}

/** No axis needs more; keeps a degenerate window from filling the memory. */
const MOST = 200;

/**
 * Round places in an interval: the smallest step of the form 1, 2 or 5 times a power of ten that keeps
 * neighbours at least `spacing` pixels apart, at `scale` pixels per unit. Empty where a length is not a
 * positive finite number.
 */
export function ticks([from, to]: Interval, scale: number, spacing: number): Ticks {
  const least = spacing / scale;
  if (!(least > 0 && Number.isFinite(least) && Number.isFinite(to - from))) {
    return { step: 1, values: [], digits: 0 };
  }
  const power = Math.floor(Math.log10(least) + 1e-9);
  const factor = [1, 2, 5, 10].find((f) => f * 10 ** power >= least * (1 - 1e-9)) ?? 10;
  const exponent = factor === 10 ? power + 1 : power;
  const lead = factor === 10 ? 1 : factor;
  // One rounding only: 3 · 10⁻¹ as 3 / 10.
  const at = (k: number) => (exponent < 0 ? (k * lead) / 10 ** -exponent : k * lead * 10 ** exponent);
  const step = at(1);
  const first = Math.ceil(from / step - 1e-6);
  const last = Math.min(Math.floor(to / step + 1e-6), first + MOST);
  const values = Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => at(first + i) + 0);
  return { step, values, digits: Math.max(0, -exponent) };
}
