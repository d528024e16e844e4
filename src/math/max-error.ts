import { checkInteger, checkNumbers } from "./check.ts";
import { checkOrdered } from "./check-ordered.ts";

/** The largest distance between two functions and a place where it is met. */
export type ErrorPeak = {
  readonly error: number;
  readonly at: number;
};

/**
 * The largest |f − g| over the given positions.
 *
 * @throws RangeError if there is no position or a number is not finite.
 */
export function maxErrorSampled(
  f: (x: number) => number,
  g: (x: number) => number,
  positions: readonly number[],
): ErrorPeak {
  checkNumbers("positions", positions);
  let peak: ErrorPeak = { error: -1, at: positions[0]! };
  for (const at of positions) {
    const error = Math.abs(f(at) - g(at));
    if (error > peak.error) peak = { error, at };
  }
  return peak;
}

/**
 * The largest |f − g| over [a, b]: sampled at `samples` + 1 equidistant places, then refined around every sampled
 * local maximum that could still win.
 *
 * Found to rounding error if the error curve has at most one peak between neighbouring samples; a narrower peak can be
 * missed. For polynomials against smooth functions some forty samples per degree are plenty.
 *
 * @throws RangeError if not a < b or `samples` is not a whole number ≥ 2.
 */
export function maxError(
  f: (x: number) => number,
  g: (x: number) => number,
  a: number,
  b: number,
  samples = 2000,
): ErrorPeak {
  checkOrdered("a", a, "b", b);
  checkInteger("samples", samples, 2);
  const error = (x: number) => Math.abs(f(x) - g(x));
  const place = (k: number) => (k === samples ? b : a + ((b - a) * k) / samples);
  const errors = Array.from({ length: samples + 1 }, (_, k) => error(place(k)));
  let peak: ErrorPeak = { error: -1, at: a };
  errors.forEach((here, k) => {
    if (here > peak.error) peak = { error: here, at: place(k) };
  });
  // Between two samples a smooth peak rises above them by far less than the drop to their neighbours; half is safe.
  const threshold = peak.error / 2;
  for (let k = 0; k <= samples; k++) {
    const here = errors[k]!;
    const [before, after] = [errors[k - 1] ?? 0, errors[k + 1] ?? 0];
    if (here < threshold || here < before || here < after) continue;
    const refined = goldenSection(error, place(Math.max(k - 1, 0)), place(Math.min(k + 1, samples)));
    if (refined.error > peak.error) peak = refined;
  }
  return peak;
}

/** The maximum of a function with one peak in [low, high], by golden section. */
function goldenSection(error: (x: number) => number, low: number, high: number): ErrorPeak {
  const ratio = (Math.sqrt(5) - 1) / 2;
  let x1 = high - ratio * (high - low);
  let x2 = low + ratio * (high - low);
  let e1 = error(x1);
  let e2 = error(x2);
  // 40 steps narrow the interval by 4·10⁻⁹; the error is flat at its peak, so its value is then exact to rounding.
  for (let step = 0; step < 40; step++) {
    if (e1 > e2) {
      [high, x2, e2] = [x2, x1, e1];
      x1 = high - ratio * (high - low);
      e1 = error(x1);
    } else {
      [low, x1, e1] = [x1, x2, e2];
      x2 = low + ratio * (high - low);
      e2 = error(x2);
    }
  }
  return e1 > e2 ? { error: e1, at: x1 } : { error: e2, at: x2 };
}
