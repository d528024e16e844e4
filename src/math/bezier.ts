import { checkInteger, checkPoints } from "./check.ts";
import { deCasteljau } from "./de-casteljau.ts";
import { type Point, scale, sub, zero } from "./point.ts";

/**
 * The point of a Bézier curve at t, by de Casteljau's construction.
 *
 * `controlPoints` b_0 … b_n, any degree n ≥ 0, any dimension; p(0) = b_0 and p(1) = b_n exactly. Any finite t.
 *
 * @throws RangeError if there is no control point, dimensions differ or a number is not finite.
 */
export function bezierPoint(controlPoints: readonly Point[], t: number): Point {
  return deCasteljau(controlPoints, t).at(-1)![0]!;
}

/**
 * The r-th derivative of a Bézier curve at t: a vector, the zero vector for r > n, the point itself for r = 0.
 *
 * Differences of coordinates, times n!/(n − r)!, must stay within the range of doubles: up to 1e300 they do.
 *
 * @throws RangeError as `bezierPoint`, and if r is not a whole number ≥ 0.
 */
export function bezierDerivative(controlPoints: readonly Point[], t: number, r = 1): Point {
  return bezierPoint(hodograph(controlPoints, r), t);
}

/**
 * The hodograph of a Bézier curve: control points n·(b_{i+1} − b_i) of its derivative, of degree n − 1.
 *
 * `r` repeats the step: the r-th derivative, of degree n − r; for r > n the zero curve of degree 0.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or r is not a whole
 * number ≥ 0.
 */
export function hodograph(controlPoints: readonly Point[], r = 1): Point[] {
  const dimension = checkPoints("controlPoints", controlPoints);
  checkInteger("r", r, 0);
  const n = controlPoints.length - 1;
  if (r > n) return [zero(dimension)];
  let points = [...controlPoints];
  for (let k = 0; k < r; k++) {
    points = points.slice(1).map((next, i) => scale(sub(next, points[i]!), n - k));
  }
  return points;
}
