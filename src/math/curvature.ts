import type { Curve } from "./curve.ts";
import { cross, cross2, dot, norm, type Point, parallelogramArea, scale, sub } from "./point.ts";
import { isRegular } from "./tangent.ts";

/**
 * The curvature at t: in the plane det(p′, p″) / ‖p′‖³, positive for a left turn (y up); in other dimensions
 * ‖p′ × p″‖ / ‖p′‖³ ≥ 0. Its unit is 1 / length; its reciprocal is the radius of the osculating circle.
 *
 * `null` where the first derivative vanishes (below 1e-10 of the curve's speed).
 */
export function curvature(curve: Curve, t: number): number | null {
  if (!isRegular(curve, t)) return null;
  const first = curve.derivative(t, 1);
  const second = curve.derivative(t, 2);
  const area = curve.dimension === 2 ? cross2(first, second) : parallelogramArea(first, second);
  return area / norm(first) ** 3;
}

/**
 * The curvature vector: the second derivative with respect to arc length. It points to the centre of the osculating
 * circle, and its length is the modulus of the curvature.
 *
 * `null` where the first derivative vanishes.
 */
export function curvatureVector(curve: Curve, t: number): Point | null {
  if (!isRegular(curve, t)) return null;
  return curvatureVectorOf(curve.derivative(t, 1), curve.derivative(t, 2));
}

/** The part of the second derivative across the first, divided by ‖p′‖²; the first derivative must not be zero. */
export function curvatureVectorOf(first: Point, second: Point): Point {
  const squared = dot(first, first);
  const across = sub(second, scale(first, dot(first, second) / squared));
  return scale(across, 1 / squared);
}

/**
 * The torsion det(p′, p″, p‴) / ‖p′ × p″‖² of a curve in space, positive for a right-handed screw; 0 for a plane curve.
 *
 * `null` where the first derivative vanishes or the first two are parallel (angle below 1e-10): there is no osculating
 * plane.
 *
 * @throws RangeError if the curve does not lie in space.
 */
export function torsion(curve: Curve, t: number): number | null {
  if (curve.dimension !== 3) {
    throw new RangeError(`curve: expected a curve in 3 dimensions, got ${curve.dimension}`);
  }
  if (!isRegular(curve, t)) return null;
  const [first, second, third] = [1, 2, 3].map((r) => curve.derivative(t, r)) as [Point, Point, Point];
  const binormal = cross(first, second);
  const length = curve.domain[1] - curve.domain[0];
  // A second derivative that is only rounding error has no direction: measure it against the first one.
  const size = norm(first) * (norm(second) + norm(first) / length);
  if (norm(binormal) <= 1e-10 * size) return null;
  return dot(binormal, third) / dot(binormal, binormal);
}
