import { checkNumber, checkPoint } from "./check.ts";
import type { Point } from "./point.ts";

/*
 * One curve in three representations, the nodal cubic: parametric Q(t) = (t², t³ − t), implicit
 * f(x, y) = x³ − 2x² + x − y² = 0, explicit y = √(x³) − √x, which is the branch t ≥ 0 only. It crosses itself in (1, 0).
 */

/** The point (t², t³ − t); any finite t. */
export function nodalCubicPoint(t: number): Point {
  checkNumber("t", t);
  return [t * t, t * (t - 1) * (t + 1)];
}

/** The tangent vector (2t, 3t² − 1), which is never zero. */
export function nodalCubicTangent(t: number): Point {
  checkNumber("t", t);
  return [2 * t, 3 * t * t - 1];
}

/** The ordinate √(x³) − √x of the branch t ≥ 0, or `null` for x < 0, where the curve has no point. */
export function nodalCubicBranch(x: number): number | null {
  checkNumber("x", x);
  return x < 0 ? null : Math.sqrt(x) * (x - 1);
}

/** The value of f(x, y) = x·(x − 1)² − y²: zero on the curve, negative outside and positive inside its loop. */
export function nodalCubicValue(point: Point): number {
  checkPoint("point", point, 2);
  const [x, y] = point as readonly [number, number];
  return x * (x - 1) * (x - 1) - y * y;
}

/** The gradient ((x − 1)(3x − 1), −2y) of f, across the curve; zero at the crossing (1, 0). */
export function nodalCubicGradient(point: Point): Point {
  checkPoint("point", point, 2);
  const [x, y] = point as readonly [number, number];
  return [(x - 1) * (3 * x - 1), -2 * y];
}

/**
 * All parameters t with Q(t) = point, ascending: two at the crossing, one elsewhere on the curve, none off it.
 *
 * `tolerance` is the distance allowed between the ordinates, relative to 1 + |y|.
 */
export function nodalCubicParameters(point: Point, tolerance = 1e-9): number[] {
  checkPoint("point", point, 2);
  const [x, y] = point as readonly [number, number];
  if (x < -tolerance) return [];
  const root = Math.sqrt(Math.max(0, x));
  const candidates = root === 0 ? [0] : [-root, root];
  return candidates.filter((t) => Math.abs(nodalCubicPoint(t)[1]! - y) <= tolerance * (1 + Math.abs(y)));
}

/** All ordinates y with f(x, y) = 0, ascending: ±√x·(x − 1); one at x = 0 and x = 1, none for x < 0. */
export function nodalCubicOrdinates(x: number): number[] {
  const y = nodalCubicBranch(x);
  if (y === null) return [];
  return y === 0 ? [0] : [-Math.abs(y), Math.abs(y)];
}
