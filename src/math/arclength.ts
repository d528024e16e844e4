import { checkNumber, checkPositive } from "./check.ts";
import type { Curve } from "./curve.ts";
import { findRoot } from "./find-root.ts";
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
  const [start, end] = curve.domain;
  if (length <= 0) return start;
  /** How much longer the curve is up to t; 0 if that is within the accuracy. */
  const excess = (t: number): number => {
    const difference = arclength(curve, accuracy / 4, start, t) - length;
    return Math.abs(difference) <= accuracy / 2 ? 0 : difference;
  };
  return excess(end) <= 0 ? end : findRoot(excess, start, end, 0);
}
