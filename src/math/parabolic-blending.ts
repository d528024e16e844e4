import { checkInteger, checkNumber, checkPoints } from "./check.ts";
import { hermiteCoefficients } from "./hermite-segment.ts";
import { type HermiteSpline, hermiteSpline } from "./hermite-spline.ts";
import { combine, lerp, type Point, scale, sub } from "./point.ts";

/**
 * The parabola through `before` at t = −1, `here` at t = 0 and `after` at t = 1.
 *
 * Its weights are the Lagrange polynomials of degree 2 on these nodes.
 */
// #region parabolic-blending
export function parabolaPoint(before: Point, here: Point, after: Point, t: number): Point {
  return combine([(t * (t - 1)) / 2, -(t + 1) * (t - 1), (t * (t + 1)) / 2], [before, here, after]);
}

function blend(points: readonly Point[], r: number, t: number): Point {
  const [before, start, end, after] = [points[r - 1], points[r]!, points[r + 1]!, points[r + 2]];
  const first = before && parabolaPoint(before, start, end, t);
  const second = after && parabolaPoint(start, end, after, t - 1);
  if (first && second) return lerp(first, second, t);
  return (first ?? second)!;
}
// #endregion

/**
 * Parabolic blending: the point S_r(t) between the points r and r + 1, t in [0, 1].
 *
 * S_r(t) = (1 − t)·Q_r(t) + t·Q_{r+1}(t − 1), where the parabola Q_r meets the points r − 1, r, r + 1 at −1, 0, 1. In
 * the first and the last segment there is only one parabola, which is kept.
 * After A. W. Overhauser, Analytic definition of curves and surfaces by parabolic blending.
 *
 * @throws RangeError if there are fewer than three points, dimensions differ, a number is not finite or there is no
 * segment r.
 */
export function parabolicBlend(points: readonly Point[], r: number, t: number): Point {
  checkPoints("points", points, 3);
  checkInteger("r", r, 0, points.length - 2);
  checkNumber("t", t);
  return blend(points, r, t);
}

/**
 * The curve of parabolic blending over [0, n], segment r over [r, r + 1]: C¹, local, through all n + 1 points.
 *
 * Inside it is the uniform Catmull-Rom spline, that is the Hermite spline with the tangents (P_{r+1} − P_{r−1})/2; at
 * the ends the tangents are those of the end parabolas, (−3P_0 + 4P_1 − P_2)/2 and mirrored.
 *
 * @throws RangeError if there are fewer than three points, dimensions differ or a number is not finite.
 */
export function parabolicBlending(points: readonly Point[]): HermiteSpline {
  checkPoints("points", points, 3);
  const n = points.length - 1;
  const tangents = points.map((_, r) => {
    if (r === 0) return combine([-1.5, 2, -0.5], points.slice(0, 3));
    if (r === n) return combine([0.5, -2, 1.5], points.slice(n - 2));
    return scale(sub(points[r + 1]!, points[r - 1]!), 0.5);
  });
  const nodes = points.map((_, r) => r);
  return hermiteSpline(nodes, points, tangents);
}

/**
 * The coefficients [A, B, C, D] of every segment as A·t³ + B·t² + C·t + D, t in [0, 1]; A = 0 in the end pieces.
 *
 * @throws RangeError as `parabolicBlending`.
 */
export function parabolicCoefficients(points: readonly Point[]): [Point, Point, Point, Point][] {
  const { tangents } = parabolicBlending(points);
  return points
    .slice(1)
    .map((end, r) => hermiteCoefficients(points[r]!, tangents[r]!, tangents[r + 1]!, end));
}
