import { checkPoints } from "./check.ts";
import type { Curve } from "./curve.ts";
import { deBoorScheme } from "./de-boor.ts";
import { checkCurveKnots, knotBreaks, knotDomain } from "./knots.ts";
import { norm, type Point, scale, sub, zero } from "./point.ts";

/** The data of a B-spline curve: degree p, n + 1 control points, n + p + 2 knots. */
export type BSpline = {
  readonly degree: number;
  readonly knots: readonly number[];
  readonly controlPoints: readonly Point[];
};

/**
 * The B-spline curve Σ d_i · N_i^p(t) over [u_p, u_{n+1}], evaluated by de Boor's algorithm.
 *
 * A control point acts on p + 1 spans only; the curve lies in the convex hulls of p + 1 neighbouring control points; at
 * a knot of multiplicity s it is C^{p−s}. Derivatives at a knot are taken from the right, at the right end from the
 * left.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or for bad knots (see
 * `checkCurveKnots`).
 */
export function bsplineCurve(
  degree: number,
  knots: readonly number[],
  controlPoints: readonly Point[],
): Curve {
  const dimension = checkPoints("controlPoints", controlPoints);
  checkCurveKnots(degree, knots, controlPoints.length);
  const derivative = bsplineDerivatives({ degree, knots, controlPoints });
  const hodograph = bsplineHodograph({ degree, knots, controlPoints });
  const speed = hodograph.controlPoints.reduce((max, leg) => Math.max(max, norm(leg)), 0);
  const breaks = knotBreaks(degree, knots).slice(1, -1);
  return onDomain({
    dimension,
    domain: knotDomain(degree, knots),
    point: (t) => derivative(t, 0),
    derivative,
    breaks,
    speed,
  });
}

/** A function (t, r = 1) → r-th derivative of a checked B-spline; the derivative splines are made once each. */
export function bsplineDerivatives(spline: BSpline): (t: number, r?: number) => Point {
  const splines = [spline];
  return (t, r = 1) => {
    // Beyond the degree every derivative is zero; the spline of order degree + 1 says so.
    const order = Math.min(r, spline.degree + 1);
    while (splines.length <= order) splines.push(bsplineHodograph(splines.at(-1)!));
    const { degree, knots, controlPoints } = splines[order]!;
    return deBoorScheme(degree, knots, controlPoints, t).levels.at(-1)![0]!;
  };
}

/**
 * The derivative of a B-spline as a B-spline of degree p − 1: control points p·(d_{i+1} − d_i)/(u_{i+p+1} − u_{i+1}), the
 * knots without the first and the last. For degree 0 the zero curve.
 *
 * Where a knot of multiplicity p + 1 makes the denominator 0, the control point acts nowhere and is set to zero.
 */
export function bsplineHodograph({ degree, knots, controlPoints }: BSpline): BSpline {
  const none = zero(controlPoints[0]!.length);
  if (degree === 0) return { degree, knots, controlPoints: controlPoints.map(() => none) };
  const legs = controlPoints.slice(1).map((next, i) => {
    const width = knots[i + degree + 1]! - knots[i + 1]!;
    return width === 0 ? none : scale(sub(next, controlPoints[i]!), degree / width);
  });
  return { degree: degree - 1, knots: knots.slice(1, -1), controlPoints: legs };
}

/** Restricts a curve to a part of its domain when it is split; points and parameters stay. */
function onDomain(curve: Curve): Curve {
  const [a, b] = curve.domain;
  const part = (domain: readonly [number, number]) =>
    onDomain({ ...curve, domain, breaks: curve.breaks!.filter((t) => t > domain[0] && t < domain[1]) });
  return { ...curve, split: (t) => [part([a, t]), part([t, b])] };
}
