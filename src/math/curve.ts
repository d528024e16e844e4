import { hodograph } from "./bezier.ts";
import { bezierPointInto, fromFlat, toFlat } from "./bezier-batch.ts";
import { checkInteger, checkInterval, checkPoints, checkPositive, checkWeights } from "./check.ts";
import { norm, type Point, scale } from "./point.ts";
import { rationalBezierDerivative } from "./rational-bezier.ts";
import { splitBezier } from "./split-bezier.ts";

/**
 * A parametric curve [a, b] → ℝᵈ: what arc length, nearest point, curvature, frames and flattening need to know.
 *
 * A value of this type is valid: its builder has checked the data. Its functions accept every finite t (outside the
 * domain the formula is continued) and return finite coordinates.
 */
export type Curve = {
  readonly dimension: number;
  /** The parameter domain [a, b], a < b. */
  readonly domain: readonly [number, number];
  /** The curve point at t. */
  readonly point: (t: number) => Point;
  /**
   * The r-th derivative with respect to t, r ≥ 0 (0: the point); at a break the one from the right, at the right
   * end of the domain from the left.
   */
  readonly derivative: (t: number, r?: number) => Point;
  /** Ascending parameters strictly inside the domain between which the curve is smooth; none if absent. */
  readonly breaks?: readonly number[];
  /** A bound for the length of the first derivative on the domain; a derivative is zero if tiny beside it. */
  readonly speed?: number;
  /** The two pieces over [a, t] and [t, b] for a < t < b, with the parameter of the whole curve. */
  readonly split?: (t: number) => [Curve, Curve];
};

/**
 * The Bézier curve of the control points, over [0, 1] or over a domain of its own.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or the domain is empty.
 */
export function bezierCurve(
  controlPoints: readonly Point[],
  domain: readonly [number, number] = [0, 1],
): Curve {
  const dimension = checkPoints("controlPoints", controlPoints);
  checkInterval("domain", domain);
  const [a, b] = domain;
  const highest = controlPoints.length; // this derivative and all above vanish
  const hodographs = Array.from({ length: highest + 1 }, (_, r) =>
    toFlat(hodograph(controlPoints, r).map((vector) => scale(vector, (b - a) ** -r))),
  );
  const local = (t: number): number => (t - a) / (b - a);
  const derivative = (t: number, r = 1): Point => {
    checkInteger("r", r, 0);
    const vector = new Array<number>(dimension);
    bezierPointInto(vector, hodographs[Math.min(r, highest)]!, dimension, local(t));
    return vector;
  };
  return {
    dimension,
    domain,
    point: (t) => derivative(t, 0),
    derivative,
    speed: Math.max(...fromFlat(hodographs[1]!, dimension).map(norm)),
    split: (t) => {
      const [left, right] = splitBezier(controlPoints, local(t));
      return [bezierCurve(left, [a, t]), bezierCurve(right, [t, b])];
    },
  };
}

/**
 * The rational Bézier curve over [0, 1] with positive weights, which has no pole.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or a weight is not
 * positive.
 */
export function rationalBezierCurve(controlPoints: readonly Point[], weights: readonly number[]): Curve {
  const dimension = checkPoints("controlPoints", controlPoints);
  checkWeights("weights", weights, controlPoints.length);
  for (const [i, weight] of weights.entries()) checkPositive(`weights[${i}]`, weight);
  const derivative = (t: number, r = 1): Point => rationalBezierDerivative(controlPoints, weights, t, r)!;
  return { dimension, domain: [0, 1], point: (t) => derivative(t, 0), derivative };
}
