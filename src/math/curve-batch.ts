import type { Out } from "./bezier-batch.ts";
import { checkInteger } from "./check.ts";
import type { Curve } from "./curve.ts";

/**
 * Writes steps + 1 points of a curve at equidistant parameters over its domain to `out`, coordinates one after another:
 * the polyline of a drawing. Both ends of the domain are sampled.
 *
 * For curves that consist of Bézier pieces, those are exact and cheaper to draw (`splineToBezier`, `bsplineToBezier`).
 *
 * @returns the number of coordinates written, (steps + 1) · dimension.
 * @throws RangeError if `steps` is not a whole number ≥ 1.
 */
export function curvePointsInto(out: Out, curve: Curve, steps: number): number {
  checkInteger("steps", steps, 1);
  const [a, b] = curve.domain;
  let at = 0;
  for (let k = 0; k <= steps; k++) {
    const point = curve.point(a * (1 - k / steps) + b * (k / steps));
    for (let axis = 0; axis < curve.dimension; axis++) out[at++] = point[axis]!;
  }
  return at;
}
