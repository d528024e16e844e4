import { binomial } from "./bernstein.ts";
import { checkPoints, checkWeights } from "./check.ts";
import { type Point, scale, sub } from "./point.ts";

/**
 * Points with weights as points of a dimension higher: (w·x, w·y, …, w).
 *
 * A rational curve is the central projection of the polynomial curve of these points.
 *
 * @throws RangeError if there is no point, dimensions differ, a number is not finite, the counts differ or all weights
 * are 0.
 */
export function toHomogeneous(points: readonly Point[], weights: readonly number[]): Point[] {
  checkPoints("points", points);
  checkWeights("weights", weights, points.length);
  return points.map((point, i) => [...scale(point, weights[i]!), weights[i]!]);
}

/** The point (x, y, …) of homogeneous coordinates (w·x, w·y, …, w), or `null` for w = 0, a point at infinity. */
export function fromHomogeneous(point: Point): Point | null {
  const weight = point.at(-1)!;
  return weight === 0 ? null : point.slice(0, -1).map((x) => x / weight);
}

/**
 * The derivatives of order 0 … r of a rational curve at one parameter, from those of its homogeneous curve.
 *
 * By Leibniz' rule for (w·p) = a: p⁽ᵏ⁾ = (a⁽ᵏ⁾ − Σ (k over i) · w⁽ⁱ⁾ · p⁽ᵏ⁻ⁱ⁾, i = 1 … k) / w.
 *
 * `derivatives[k]` is (a⁽ᵏ⁾, w⁽ᵏ⁾); `null` where |w| is at most `threshold`: the curve has a pole there (or, if the
 * numerator vanishes too, an undefined point).
 */
export function projectDerivatives(derivatives: readonly Point[], threshold = 0): Point[] | null {
  const weight = derivatives[0]!.at(-1)!;
  if (Math.abs(weight) <= threshold) return null;
  const result: Point[] = [];
  derivatives.forEach((homogeneous, k) => {
    let vector: Point = homogeneous.slice(0, -1);
    for (let i = 1; i <= k; i++) {
      vector = sub(vector, scale(result[k - i]!, binomial(k, i) * derivatives[i]!.at(-1)!));
    }
    result.push(vector.map((x) => x / weight));
  });
  return result;
}

/** A denominator this small beside the largest weight counts as zero: a pole up to rounding. */
export const poleThreshold = 1e-10;
