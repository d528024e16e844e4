import { bernsteinRoots } from "./bernstein-roots.ts";
import { bezierPoint, hodograph } from "./bezier.ts";
import type { Point } from "./point.ts";

/**
 * For each coordinate the parameters inside (0, 1) where it has a local extremum, ascending: its derivative changes
 * sign there.
 *
 * A saddle (zero derivative without change of sign) is none; a constant coordinate has none.
 *
 * @throws RangeError if there is no control point, dimensions differ or a number is not finite.
 */
export function bezierExtrema(controlPoints: readonly Point[]): number[][] {
  const derivative = hodograph(controlPoints);
  return controlPoints[0]!.map((_, axis) => {
    const coefficients = derivative.map((vector) => vector[axis]!);
    const size = Math.max(...controlPoints.map((point) => Math.abs(point[axis]!)));
    // A coordinate that is constant up to rounding does not turn.
    if (Math.max(...coefficients.map(Math.abs)) <= 1e-14 * controlPoints.length * size) return [];
    return bernsteinRoots(coefficients).flatMap((root) => (root.signChange ? [root.t] : []));
  });
}

/**
 * The smallest box with sides along the axes that holds the Bézier curve (not its control polygon).
 *
 * @throws RangeError as `bezierExtrema`.
 */
export function bezierBounds(controlPoints: readonly Point[]): { min: Point; max: Point } {
  const ends = [controlPoints[0]!, controlPoints.at(-1)!];
  const sides = bezierExtrema(controlPoints).map((ts, axis) => {
    const values = [...ends, ...ts.map((t) => bezierPoint(controlPoints, t))].map((point) => point[axis]!);
    return { min: Math.min(...values), max: Math.max(...values) };
  });
  return { min: sides.map((side) => side.min), max: sides.map((side) => side.max) };
}
