import { bezierDerivative } from "./bezier.ts";
import { checkInteger } from "./check.ts";
import { fromHomogeneous, poleThreshold, projectDerivatives, toHomogeneous } from "./homogeneous.ts";
import type { Point } from "./point.ts";
import { splitBezier } from "./split-bezier.ts";

/**
 * The point Σ w_i b_i B_i^n(t) / Σ w_i B_i^n(t) of a rational Bézier curve, or `null` at a pole.
 *
 * Control points are Euclidean (not multiplied by their weights). Weights of any sign; positive weights have no pole
 * on [0, 1]. A denominator below 1e-10 of the largest weight counts as zero.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite, the counts differ or all
 * weights are 0.
 */
export function rationalBezierPoint(
  controlPoints: readonly Point[],
  weights: readonly number[],
  t: number,
): Point | null {
  return rationalBezierDerivative(controlPoints, weights, t, 0);
}

/**
 * The r-th derivative of a rational Bézier curve at t (r = 0: the point), or `null` at a pole.
 *
 * @throws RangeError as `rationalBezierPoint`, and if r is not a whole number ≥ 0.
 */
export function rationalBezierDerivative(
  controlPoints: readonly Point[],
  weights: readonly number[],
  t: number,
  r = 1,
): Point | null {
  checkInteger("r", r, 0);
  const homogeneous = toHomogeneous(controlPoints, weights);
  const derivatives = Array.from({ length: r + 1 }, (_, k) => bezierDerivative(homogeneous, t, k));
  const largest = Math.max(...weights.map(Math.abs));
  return projectDerivatives(derivatives, poleThreshold * largest)?.[r] ?? null;
}

/**
 * Splits a rational Bézier curve at t into two with control points and weights of their own.
 *
 * `null` if a control point of a piece would lie at infinity (a weight 0 arises), which positive weights exclude.
 *
 * @throws RangeError as `rationalBezierPoint`.
 */
export function splitRationalBezier(
  controlPoints: readonly Point[],
  weights: readonly number[],
  t: number,
): [RationalBezier, RationalBezier] | null {
  const [left, right] = splitBezier(toHomogeneous(controlPoints, weights), t).map(project);
  return left && right ? [left, right] : null;
}

/** A rational Bézier curve: Euclidean control points and their weights. */
export type RationalBezier = {
  readonly controlPoints: readonly Point[];
  readonly weights: readonly number[];
};

function project(homogeneous: readonly Point[]): RationalBezier | null {
  const controlPoints = homogeneous.map(fromHomogeneous);
  if (!controlPoints.every((point) => point !== null)) return null;
  return { controlPoints, weights: homogeneous.map((point) => point.at(-1)!) };
}
