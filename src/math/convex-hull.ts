import { checkPoints } from "./check.ts";
import { cross2, norm, type Point, sub } from "./point.ts";

/**
 * The vertices of the convex hull of points in the plane, counter-clockwise from the one with the smallest x (of
 * several, the smallest y).
 *
 * No vertex is repeated and none lies on an edge, up to rounding of the coordinates. Collinear points give the two ends
 * of their segment, coincident points one point. Andrew's monotone chain, O(n log n).
 *
 * Source: A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions (1979).
 *
 * @throws RangeError if there is no point, a point is not in the plane or a number is not finite.
 */
export function convexHull(points: readonly Point[]): Point[] {
  checkPoints("points", points, 1, 2);
  const sorted = [...points].sort((p, q) => p[0]! - q[0]! || p[1]! - q[1]!);
  const lower = chain(sorted);
  const upper = chain(sorted.reverse());
  // The end of each chain is the start of the other; coincident points leave a single one in both.
  return lower.length === 1 ? lower : [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

/** From left to right only left turns: the lower half of the hull. */
function chain(sorted: readonly Point[]): Point[] {
  const hull: Point[] = [];
  for (const point of sorted) {
    while (hull.length >= 2 && !turnsLeft(hull.at(-2)!, hull.at(-1)!, point)) hull.pop();
    const last = hull.at(-1);
    if (!last || last[0] !== point[0] || last[1] !== point[1]) hull.push(point);
  }
  return hull;
}

function turnsLeft(a: Point, b: Point, c: Point): boolean {
  const u = sub(b, a);
  const v = sub(c, b);
  // An angle below 1e-10 counts as straight, and so does a turn that the rounding of the coordinates can make.
  const rounding = 4e-16 * (norm(a) + norm(b) + norm(c));
  return cross2(u, v) > 1e-10 * norm(u) * norm(v) + rounding * (norm(u) + norm(v));
}
