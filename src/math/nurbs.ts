import { type BSpline, bsplineDerivatives } from "./bspline.ts";
import { checkInteger, checkNumber, checkPoints, checkPositive, checkWeights } from "./check.ts";
import type { Curve } from "./curve.ts";
import { poleThreshold, projectDerivatives, toHomogeneous } from "./homogeneous.ts";
import { bsplineToBezier } from "./insert-knot.ts";
import { checkCurveKnots, knotBreaks, knotDomain } from "./knots.ts";
import { add, type Point, scale } from "./point.ts";
import type { RationalBezier } from "./rational-bezier.ts";

/** The data of a rational B-spline curve (NURBS); control points are Euclidean, not multiplied by their weights. */
export type Nurbs = BSpline & { readonly weights: readonly number[] };

/**
 * The r-th derivative at t of a rational B-spline curve Σ w_i d_i N_i^p / Σ w_i N_i^p (r = 0: the point), or `null` at
 * a pole.
 *
 * Weights of any sign; positive weights have no pole in the domain. A denominator below 1e-10 of the largest weight
 * counts as zero.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite, for bad knots (see
 * `checkCurveKnots`), if the weights do not fit or all are 0, or if r is not a whole number ≥ 0.
 */
export function nurbsDerivative(
  { degree, knots, controlPoints, weights }: Nurbs,
  t: number,
  r = 0,
): Point | null {
  checkNumber("t", t);
  checkInteger("r", r, 0);
  return evaluator({ degree, knots, controlPoints, weights })(t, r);
}

/**
 * The rational B-spline curve with positive weights, which has no pole.
 *
 * @throws RangeError as `nurbsDerivative`, and if a weight is not positive.
 */
export function nurbsCurve(nurbs: Nurbs): Curve {
  nurbs.weights.forEach((weight, i) => {
    checkPositive(`weights[${i}]`, weight);
  });
  const evaluate = evaluator(nurbs);
  const derivative = (t: number, r = 1): Point => evaluate(t, r)!;
  return {
    dimension: nurbs.controlPoints[0]!.length,
    domain: knotDomain(nurbs.degree, nurbs.knots),
    point: (t) => derivative(t, 0),
    derivative,
    breaks: knotBreaks(nurbs.degree, nurbs.knots).slice(1, -1),
  };
}

/**
 * The rational Bézier curves of which a NURBS with positive weights consists, piece i over [breaks[i], breaks[i+1]].
 *
 * @throws RangeError as `nurbsCurve`.
 */
export function nurbsToBezier({ degree, knots, controlPoints, weights }: Nurbs): {
  readonly breaks: number[];
  readonly segments: RationalBezier[];
} {
  checkWeights("weights", weights, controlPoints.length);
  weights.forEach((weight, i) => {
    checkPositive(`weights[${i}]`, weight);
  });
  const { breaks, segments } = bsplineToBezier(degree, knots, toHomogeneous(controlPoints, weights));
  return {
    breaks,
    segments: segments.map((segment) => ({
      controlPoints: segment.map((point) => scale(point.slice(0, -1), 1 / point.at(-1)!)),
      weights: segment.map((point) => point.at(-1)!),
    })),
  };
}

/**
 * The exact circle as a NURBS of degree 2: nine control points on the square around it, the corners with weight √½;
 * each quarter is a rational Bézier parabola over [0, ¼], … No polynomial curve is a circle.
 *
 * It starts at angle 0 and runs counter-clockwise; the parameter is not proportional to the angle.
 *
 * @throws RangeError unless the centre is a point in the plane and the radius is positive.
 */
export function nurbsCircle(centre: Point = [0, 0], radius = 1): Nurbs {
  checkPoints("centre", [centre], 1, 2);
  checkPositive("radius", radius);
  const square: Point[] = [
    [1, 0],
    [1, 1],
    [0, 1],
    [-1, 1],
    [-1, 0],
    [-1, -1],
    [0, -1],
    [1, -1],
    [1, 0],
  ];
  return {
    degree: 2,
    knots: [0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1],
    controlPoints: square.map((corner) => add(centre, scale(corner, radius))),
    weights: square.map((_, i) => (i % 2 === 0 ? 1 : Math.SQRT1_2)),
  };
}

/** Checks the data once and gives (t, r) → r-th derivative. */
function evaluator({ degree, knots, controlPoints, weights }: Nurbs): (t: number, r: number) => Point | null {
  const homogeneous = toHomogeneous(controlPoints, weights);
  checkCurveKnots(degree, knots, controlPoints.length);
  const derivative = bsplineDerivatives({ degree, knots, controlPoints: homogeneous });
  const threshold = poleThreshold * weights.reduce((max, w) => Math.max(max, Math.abs(w)), 0);
  return (t, r) => {
    const derivatives = Array.from({ length: r + 1 }, (_, k) => derivative(t, k));
    return projectDerivatives(derivatives, threshold)?.[r] ?? null;
  };
}
