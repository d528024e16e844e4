import { checkPoint } from "./check.ts";
import { angleBetween, dot, type Point } from "./point.ts";

/**
 * The factor k with `vector` = k · `direction`, or `null` if the two are not parallel; negative for opposite directions.
 *
 * Parallel means: up to `tolerance`, an angle in radians. The zero vector has no direction and gives `null`.
 *
 * @throws RangeError if dimensions differ or a number is not finite.
 */
export function parallelFactor(vector: Point, direction: Point, tolerance = 1e-6): number | null {
  checkPoint("vector", vector);
  checkPoint("direction", direction, vector.length);
  const angle = angleBetween(vector, direction);
  if (angle === null || Math.min(angle, Math.PI - angle) > tolerance) return null;
  return dot(vector, direction) / dot(direction, direction);
}
