import { deCasteljau } from "./de-casteljau.ts";
import type { Point } from "./point.ts";

/**
 * Splits a Bézier curve at t: the control points of the pieces over [0, t] and [t, 1], both in the curve's direction.
 *
 * They are the two sides of de Casteljau's triangle, b_0^r and b_{n−r}^r. Each piece has the degree of the whole and
 * its own parameter in [0, 1]. For t outside [0, 1] one piece runs beyond the curve and the other back.
 *
 * @throws RangeError if there is no control point, dimensions differ or a number is not finite.
 */
export function splitBezier(controlPoints: readonly Point[], t: number): [Point[], Point[]] {
  const levels = deCasteljau(controlPoints, t);
  const left = levels.map((level) => level[0]!);
  const right = levels.map((level) => level.at(-1)!).reverse();
  return [left, right];
}

/**
 * The control points of the piece over [t0, t1], which runs from p(t0) to p(t1); reversed for t0 > t1, the point
 * p(t0) as often as before for t0 = t1.
 *
 * @throws RangeError as `splitBezier`.
 */
export function bezierSegment(controlPoints: readonly Point[], t0: number, t1: number): Point[] {
  // Split at the end farther from the other end of [0, 1], so that the second parameter stays well defined.
  if (Math.abs(1 - t0) >= Math.abs(t1)) {
    const right = splitBezier(controlPoints, t0)[1];
    return t0 === 1 ? right : splitBezier(right, (t1 - t0) / (1 - t0))[0];
  }
  const left = splitBezier(controlPoints, t1)[0];
  return splitBezier(left, t0 / t1)[1];
}
