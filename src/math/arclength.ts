import { checkNumber, checkPositive } from "./check.ts";
import type { Curve } from "./curve.ts";
import { integrate } from "./integrate.ts";
import { norm } from "./point.ts";

/**
 * The arc length of a curve between two parameters, by default its whole domain: the integral of ‖p′(t)‖.
 *
 * `accuracy` is the error allowed, as a length; it is met except where rounding, some 1e-15 of the length, is larger. Cusps
 * are allowed. Negative for from > to.
 *
 * @throws RangeError if `accuracy` is not positive or a parameter not finite.
 */
export function arclength(
  curve: Curve,
  accuracy: number,
  from: number = curve.domain[0],
  to: number = curve.domain[1],
): number {
  checkPositive("accuracy", accuracy);
  checkNumber("from", from);
  checkNumber("to", to);
  if (from > to) return -arclength(curve, accuracy, to, from);
  const stops = [from, ...(curve.breaks ?? []).filter((t) => t > from && t < to), to];
  const share = accuracy / (stops.length - 1);
  let length = 0;
  for (let i = 1; i < stops.length; i++) {
    const [start, end] = [stops[i - 1]!, stops[i]!];
    // At its end, a break, a piece has the derivative from the left.
    const last = end - Math.max(1e-14 * (end - start), Number.EPSILON * Math.abs(end));
    const speed = (t: number): number => norm(curve.derivative(t < end ? t : last));
    length += integrate(speed, start, end, share);
  }
  return length;
}

/**
 * The parameter t at which the arc length from the start of the domain is `length`, up to an error of `accuracy` as a
 * length.
 *
 * The inverse of `arclength`. A length ≤ 0 gives the start, one beyond the curve's own the end of the domain. Where the
 * curve stands still any parameter of the rest is right.
 *
 * @throws RangeError if `accuracy` is not positive or `length` not finite.
 */
export function parameterAtLength(curve: Curve, length: number, accuracy: number): number {
  checkNumber("length", length);
  checkPositive("accuracy", accuracy);
  let [low, high] = curve.domain;
  if (length <= 0) return low;
  if (length >= arclength(curve, accuracy / 4) - accuracy / 4) return high;
  let t = low + (high - low) / 2;
  let before = 0; // the length up to `low`
  // Newton's method for s(t) = length, held in a bracket that bisection shrinks when Newton leaves it or takes too long.
  for (let step = 0; ; step++) {
    const reached = before + arclength(curve, accuracy / 200, low, t);
    const error = reached - length;
    if (Math.abs(error) <= accuracy / 2 || !(t > low && t < high)) return t;
    if (error < 0) {
      low = t;
      before = reached;
    } else {
      high = t;
    }
    const newton = t - error / norm(curve.derivative(t));
    t = step < 40 && newton > low && newton < high ? newton : low + (high - low) / 2;
  }
}
