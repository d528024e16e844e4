import type { BSpline } from "./bspline.ts";
import { checkInteger, checkNumber, checkPoints } from "./check.ts";
import { checkCurveKnots, knotBreaks, knotDomain, multiplicity } from "./knots.ts";
import { lerp, type Point } from "./point.ts";

/**
 * Inserts a knot `times` times (Boehm): the same curve with more knots and control points.
 *
 * The new control points d_i* = (1 − a_i)·d_{i−1} + a_i·d_i, with a_i = (t − u_i)/(u_{i+p} − u_i) limited to [0, 1], lie
 * on the legs of the old control polygon: corners are cut. At multiplicity p the control point is on the curve.
 * After W. Boehm, Inserting new knots into B-spline curves.
 *
 * @throws RangeError if t is outside the domain, the multiplicity would exceed the degree, `times` is not a whole
 * number ≥ 0, or as `bsplineCurve`.
 */
export function insertKnot(
  degree: number,
  knots: readonly number[],
  controlPoints: readonly Point[],
  t: number,
  times = 1,
): BSpline {
  checkPoints("controlPoints", controlPoints);
  checkCurveKnots(degree, knots, controlPoints.length);
  checkNumber("t", t);
  checkInteger("times", times, 0);
  const [a, b] = knotDomain(degree, knots);
  if (t < a || t > b) throw new RangeError(`t: expected a parameter in the domain [${a}, ${b}], got ${t}`);
  const present = multiplicity(knots, t);
  if (times > 0 && present + times > degree) {
    throw new RangeError(
      `times: expected at most ${Math.max(degree - present, 0)}, since ${t} is a knot ${present} times and the degree is ${degree}, got ${times}`,
    );
  }
  let spline: BSpline = { degree, knots, controlPoints };
  for (let k = 0; k < times; k++) spline = insertOnce(spline, t);
  return spline;
}

function insertOnce({ degree, knots, controlPoints }: BSpline, t: number): BSpline {
  const d = controlPoints;
  const refined = [...d, d[0]!].map((_, i) => {
    // a_i: 1 where d_i* = d_i is before all that changes, 0 where d_i* = d_{i−1} is behind it.
    if (knots[i + degree]! <= t) return d[i]!;
    if (knots[i]! >= t) return d[i - 1]!;
    return lerp(d[i - 1]!, d[i]!, (t - knots[i]!) / (knots[i + degree]! - knots[i]!));
  });
  // There is a greater knot: t itself occurs at most p times, and p knots follow the end of the domain.
  const at = knots.findIndex((knot) => knot > t);
  return { degree, knots: [...knots.slice(0, at), t, ...knots.slice(at)], controlPoints: refined };
}

/** A B-spline as Bézier curves: piece i over [breaks[i], breaks[i+1]]. */
export type BezierPieces = { readonly breaks: number[]; readonly segments: Point[][] };

/**
 * The Bézier curves of which a B-spline consists, one for each non-empty span of the domain: every knot of the domain
 * inserted until it occurs p times.
 *
 * @throws RangeError as `bsplineCurve`.
 */
export function bsplineToBezier(
  degree: number,
  knots: readonly number[],
  controlPoints: readonly Point[],
): BezierPieces {
  checkPoints("controlPoints", controlPoints);
  checkCurveKnots(degree, knots, controlPoints.length);
  const breaks = knotBreaks(degree, knots);
  let spline: BSpline = { degree, knots, controlPoints };
  for (const t of breaks) {
    for (let s = multiplicity(knots, t); s < degree; s++) spline = insertOnce(spline, t);
  }
  // The knots of a piece are its left end p times and its right end p times; the last left end is knot k of the span.
  const segments = breaks.slice(0, -1).map((t) => {
    const k = spline.knots.lastIndexOf(t);
    return spline.controlPoints.slice(k - degree, k + 1);
  });
  return { breaks, segments };
}
