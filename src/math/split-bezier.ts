import { blossom } from "./blossom.ts";
import { checkPoints } from "./check.ts";
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
 * The control points of the piece over [t0, t1], which runs from p(t0) to p(t1): the blossoms b[t0, …, t0, t1, …, t1].
 *
 * Reversed for t0 > t1, the point p(t0) throughout for t0 = t1.
 *
 * @throws RangeError as `splitBezier`.
 */
export function bezierSegment(controlPoints: readonly Point[], t0: number, t1: number): Point[] {
  checkPoints("controlPoints", controlPoints);
  const n = controlPoints.length - 1;
  return controlPoints.map((_, i) => {
    const ts = [...new Array<number>(n - i).fill(t0), ...new Array<number>(i).fill(t1)];
    return blossom(controlPoints, ts);
  });
}
