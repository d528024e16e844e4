import { bernsteinProduct, bernsteinRoots } from "./bernstein-roots.ts";
import { hodograph } from "./bezier.ts";
import { checkPoints } from "./check.ts";
import { norm, type Point } from "./point.ts";

/**
 * The parameters inside (0, 1) where a plane Bézier curve changes from a left to a right turn or back, ascending: the
 * changes of sign of det(p′, p″).
 *
 * A straight curve has none, nor has the cusp of a cubic, where the determinant only touches 0.
 *
 * @throws RangeError if there is no control point, a point is not in the plane or a number is not finite.
 */
export function bezierInflections(controlPoints: readonly Point[]): number[] {
  checkPoints("controlPoints", controlPoints, 1, 2);
  const [dx, dy] = coordinates(hodograph(controlPoints));
  const [ddx, ddy] = coordinates(hodograph(controlPoints, 2));
  const left = bernsteinProduct(dx, ddy);
  const right = bernsteinProduct(dy, ddx);
  const determinant = left.map((value, i) => value - right[i]!);
  // What is left of a straight curve is rounding error, of the products and of the coordinates.
  const speed = Math.max(...hodograph(controlPoints).map(norm));
  const bend = Math.max(...hodograph(controlPoints, 2).map(norm));
  const rounding = 1e-15 * Math.max(...controlPoints.map(norm)) * controlPoints.length ** 2;
  const straight = 1e-10 * speed * bend + rounding * (speed + bend);
  if (Math.max(...determinant.map(Math.abs)) <= straight) return [];
  return bernsteinRoots(determinant).flatMap((root) => (root.signChange ? [root.t] : []));
}

function coordinates(points: readonly Point[]): [number[], number[]] {
  return [points.map((p) => p[0]!), points.map((p) => p[1]!)];
}
