import { checkNumber, checkPoint } from "./check.ts";
import { lerp, type Point } from "./point.ts";

/** A linearly interpolated value, with the share `alpha` of the second data point in it. */
export type LinearValue = {
  readonly alpha: number;
  readonly value: number;
};

/** The value (1 − alpha)·v₁ + alpha·v₂: v₁ for alpha = 0 and v₂ for alpha = 1, both exactly. */
export function mix(v1: number, v2: number, alpha: number): number {
  return (1 - alpha) * v1 + alpha * v2;
}

/**
 * Linear interpolation from the distances d₁, d₂ ≥ 0 to two data points: alpha = d₁/(d₁ + d₂).
 *
 * `null` if both distances are 0: the data points coincide and the value is not determined.
 *
 * @throws RangeError if a number is not finite or a distance is negative.
 */
export function linearFromDistances(v1: number, v2: number, d1: number, d2: number): LinearValue | null {
  checkNumber("v1", v1);
  checkNumber("v2", v2);
  checkDistance("d1", d1);
  checkDistance("d2", d2);
  const largest = Math.max(d1, d2);
  if (largest === 0) return null;
  // Dividing by the larger distance first keeps the sum from overflowing.
  const alpha = d1 / largest / (d1 / largest + d2 / largest);
  return { alpha, value: mix(v1, v2, alpha) };
}

/**
 * The value at a position from two data points (p₁, v₁), (p₂, v₂) on a line: alpha = (p − p₁)/(p₂ − p₁).
 *
 * Positions beyond the data continue the line. `null` if p₁ = p₂: the value is not determined.
 *
 * @throws RangeError if a number is not finite.
 */
export function linearValue(
  p1: number,
  v1: number,
  p2: number,
  v2: number,
  position: number,
): LinearValue | null {
  Object.entries({ p1, v1, p2, v2, position }).forEach(([name, value]) => {
    checkNumber(name, value);
  });
  // The same straight line, with the parts of value and position exchanged.
  const result = linearPosition([v1], p1, [v2], p2, position);
  return result && { alpha: result.alpha, value: result.position[0]! };
}

/**
 * The position at which a value is taken between two data points: alpha = (v − v₁)/(v₂ − v₁), p = (1 − alpha)·p₁ +
 * alpha·p₂. Positions of any dimension.
 *
 * Values beyond those of the data continue the line. `null` if v₁ = v₂: no position or all of them have the value (also
 * if they differ so little that alpha is beyond the range of doubles).
 *
 * @throws RangeError if a number is not finite or the dimensions differ.
 */
export function linearPosition(
  p1: Point,
  v1: number,
  p2: Point,
  v2: number,
  value: number,
): { readonly alpha: number; readonly position: Point } | null {
  checkPoint("p1", p1);
  checkNumber("v1", v1);
  checkPoint("p2", p2, p1.length);
  checkNumber("v2", v2);
  checkNumber("value", value);
  if (v1 === v2) return null;
  // Halves, so that the difference of two large numbers of opposite sign cannot overflow.
  const alpha = (value / 2 - v1 / 2) / (v2 / 2 - v1 / 2);
  return Number.isFinite(alpha) ? { alpha, position: lerp(p1, p2, alpha) } : null;
}

function checkDistance(name: string, value: number): void {
  checkNumber(name, value);
  if (value < 0) throw new RangeError(`${name}: expected a distance of at least 0, got ${value}`);
}
