import type { Curve } from "./curve.ts";
import { norm, normalize, type Point, scale } from "./point.ts";

/** A first derivative this small beside the curve's largest speed counts as zero. */
export const relativeZero = 1e-10;

/** From which side of a parameter a limit is taken: from smaller parameters (`left`) or from larger ones. */
export type Side = "left" | "right";

/**
 * The length below which the first derivative at t counts as zero: 1e-10 of the curve's largest speed, or of the
 * derivatives of order 1 … 3 at t (over the length of the domain) where that is not known.
 */
export function zeroSpeed(curve: Curve, t: number): number {
  if (curve.speed !== undefined) return relativeZero * curve.speed;
  const length = curve.domain[1] - curve.domain[0];
  const sizes = [1, 2, 3].map((r) => norm(curve.derivative(t, r)) * length ** (r - 1));
  return relativeZero * Math.max(...sizes);
}

/** Whether the first derivative does not vanish at t, up to rounding. */
export function isRegular(curve: Curve, t: number): boolean {
  return norm(curve.derivative(t)) > zeroSpeed(curve, t);
}

/**
 * The unit tangent in the direction of growing t, also where the first derivative vanishes: there the one-sided limit.
 *
 * It is the direction of the first derivative of order r that does not vanish, reversed for even r from the left. `side` is
 * "right" by default, "left" at the right end of the domain. `null` where the first eight derivatives all vanish: the
 * curve stands still.
 */
export function unitTangent(curve: Curve, t: number, side: Side = sideAt(curve, t)): Point | null {
  const length = curve.domain[1] - curve.domain[0];
  const zero = zeroSpeed(curve, t);
  for (let r = 1; r <= 8; r++) {
    const vector = curve.derivative(t, r);
    if (norm(vector) * length ** (r - 1) <= zero) continue;
    return normalize(side === "left" && r % 2 === 0 ? scale(vector, -1) : vector);
  }
  return null;
}

function sideAt(curve: Curve, t: number): Side {
  return t >= curve.domain[1] ? "left" : "right";
}
