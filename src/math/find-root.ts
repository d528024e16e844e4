import { checkNumber } from "./check.ts";

/**
 * A zero of a function between a and b, where it changes its sign: |result − zero| ≤ accuracy.
 *
 * `f(a)` and `f(b)` must not have the same strict sign. Secant steps on a bracket that always holds a change of sign,
 * with a bisection whenever three steps have not halved the bracket: at most about three times the steps of bisection,
 * for smooth functions a handful. An `accuracy` of 0 asks for neighbouring doubles.
 *
 * @throws RangeError if a or b is not finite or f does not change its sign.
 */
export function findRoot(f: (t: number) => number, a: number, b: number, accuracy: number): number {
  checkNumber("a", a);
  checkNumber("b", b);
  let fa = f(a);
  let fb = f(b);
  if (fa === 0) return a;
  if (fb === 0) return b;
  if (fa > 0 === fb > 0) {
    throw new RangeError(`f: expected values of opposite sign at ${a} and ${b}, got ${fa} and ${fb}`);
  }
  let width = Math.abs(b - a);
  for (let step = 1; ; step++) {
    const mean = a + (b - a) / 2;
    if (Math.abs(b - a) <= accuracy || mean === a || mean === b) return mean;
    // The mean of the ends weighted by the values (the secant); the plain one if a value is infinite.
    let t = a - (fa / (fb - fa)) * (b - a);
    if (!Number.isFinite(t)) t = mean;
    if (step % 3 === 0) {
      const late = Math.abs(b - a) > width / 2;
      if (late) t = mean;
      width = Math.abs(b - a) / (late ? 2 : 1);
    }
    const ft = f(t);
    if (ft === 0) return t;
    // Illinois' rule: the end that stays counts half, so that the secant does not stick to it.
    if (ft > 0 === fb > 0) {
      fa /= 2;
    } else {
      a = b;
      fa = fb;
    }
    b = t;
    fb = ft;
  }
}
