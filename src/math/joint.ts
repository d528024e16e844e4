import { checkPositive } from "./check.ts";
import { curvatureVector } from "./curvature.ts";
import type { Curve } from "./curve.ts";
import { angleBetween, distance, norm } from "./point.ts";
import { relativeZero, type Side, unitTangent, zeroSpeed } from "./tangent.ts";

/** How two curves meet, and the numbers behind the verdict. */
export type Joint = {
  /** Equal points, equal first, equal second derivatives (each with those before). */
  readonly C0: boolean;
  readonly C1: boolean;
  readonly C2: boolean;
  /** The same as C0; equal unit tangents; equal curvature vectors, `null` (not tested) at a joint that is not regular. */
  readonly G0: boolean;
  readonly G1: boolean;
  readonly G2: boolean | null;
  /** Both first derivatives are different from zero. Only then C¹ implies G¹ and C² implies G². */
  readonly regular: boolean;
  /** Lengths of the differences of the points and of the derivatives. */
  readonly positionGap: number;
  readonly d1Gap: number;
  readonly d2Gap: number;
  /** Between the unit tangents, 0 … π; `null` if one of the curves stands still. */
  readonly tangentAngle: number | null;
  /** The length of the difference of the curvature vectors; `null` if the joint is not regular. */
  readonly curvatureGap: number | null;
  /** The k > 0 with b′ = k·a′ at a regular G¹ joint, `null` at any other; 1 if it is C¹. */
  readonly factor: number | null;
};

/**
 * Classifies the joint of the end of curve `a` with the start of curve `b`, each with the parameter of its own domain.
 *
 * G¹ asks for equal directions, with the same orientation: b′ = k·a′ with k > 0. Where a first derivative vanishes the
 * one-sided limit of the tangent takes its place. G² then asks for equal curvature vectors, that is
 * b″ = k²·a″ + c·a′ for some c; second derivatives that agree in direction only are not enough.
 *
 * `tolerance` is relative: points, derivatives and curvature vectors count as equal if they differ by at most that part of the
 * curves' size, directions up to `tolerance` in radians.
 *
 * @throws RangeError if the dimensions differ or `tolerance` is not positive.
 */
export function classifyJoint(a: Curve, b: Curve, tolerance = 1e-9): Joint {
  checkPositive("tolerance", tolerance);
  if (a.dimension !== b.dimension) {
    throw new RangeError(`b: expected a curve in ${a.dimension} dimensions as a, got ${b.dimension}`);
  }
  const end = endOf(a, a.domain[1], "left");
  const start = endOf(b, b.domain[0], "right");
  const gap = (r: number): number => distance(end.derivatives[r]!, start.derivatives[r]!);
  // What counts as equal: a part of the curves' extent, per r-th power of the parameter, and the coordinates' rounding.
  const rounding = 1e-12 * Math.max(norm(end.derivatives[0]!), norm(start.derivatives[0]!));
  const equal = (r: number): boolean => {
    const sizes = [end, start].map((side) => (tolerance * side.extent + rounding) / side.length ** r);
    return gap(r) <= Math.max(...sizes);
  };

  const C0 = equal(0);
  const C1 = C0 && equal(1);
  const C2 = C1 && equal(2);
  const tangentAngle = end.tangent && start.tangent && angleBetween(end.tangent, start.tangent);
  const G1 = C0 && tangentAngle !== null && tangentAngle <= tolerance;
  const regular = end.bend !== null && start.bend !== null;
  const curvatureGap = end.bend && start.bend && distance(end.bend, start.bend);
  let G2: boolean | null = G1 ? null : false;
  if (G1 && end.bend && start.bend) {
    const size = Math.max(norm(end.bend), norm(start.bend), 1 / Math.max(end.extent, start.extent));
    G2 = distance(end.bend, start.bend) <= tolerance * size;
  }
  const factor = G1 && regular ? norm(start.derivatives[1]!) / norm(end.derivatives[1]!) : null;
  return {
    ...{ C0, C1, C2, G0: C0, G1, G2, regular },
    ...{ positionGap: gap(0), d1Gap: gap(1), d2Gap: gap(2), tangentAngle, curvatureGap, factor },
  };
}

function endOf(curve: Curve, t: number, side: Side) {
  const length = curve.domain[1] - curve.domain[0];
  const derivatives = [0, 1, 2].map((r) => curve.derivative(t, r));
  return {
    derivatives,
    length,
    extent: length * (zeroSpeed(curve, t) / relativeZero),
    tangent: unitTangent(curve, t, side),
    bend: curvatureVector(curve, t),
  };
}
