import { checkPoints } from "./check.ts";
import { hermitePoint } from "./hermite-segment.ts";
import { type HermiteSpline, hermiteSpline } from "./hermite-spline.ts";
import { parametrize } from "./parametrize.ts";
import { add, type Point, scale, sub } from "./point.ts";

/**
 * The Catmull-Rom spline through points: at each node the tangent of the parabola through the point and its two
 * neighbours, over the nodes t_{i+1} = t_i + |P_{i+1} − P_i|^alpha.
 *
 * alpha = 0 is the uniform spline (it equals parabolic blending), ½ the centripetal one, which has neither cusps nor
 * loops within a segment, 1 the chordal one. The first and last segments are pieces of the end parabolas. C¹ and local.
 * Authors: E. Catmull and R. Rom, A class of local interpolating splines; C. Yuksel, S. Schaefer and J. Keyser,
 * Parameterization and applications of Catmull-Rom curves.
 *
 * @throws RangeError if there are fewer than three points, dimensions differ, a number is not finite, alpha is not in
 * [0, 1] or, for alpha > 0, two neighbouring points coincide.
 */
export function catmullRom(points: readonly Point[], alpha: number): HermiteSpline {
  checkPoints("points", points, 3);
  const nodes = parametrize(points, alpha);
  const n = points.length - 1;
  const tangents = points.map((_, r) => parabolaTangent(nodes, points, Math.min(Math.max(r, 1), n - 1), r));
  return hermiteSpline(nodes, points, tangents);
}

/** The derivative at node `at` of the parabola through the points middle − 1, middle, middle + 1. */
function parabolaTangent(
  nodes: readonly number[],
  points: readonly Point[],
  middle: number,
  at: number,
): Point {
  const h0 = nodes[middle]! - nodes[middle - 1]!;
  const h1 = nodes[middle + 1]! - nodes[middle]!;
  const d0 = scale(sub(points[middle]!, points[middle - 1]!), 1 / h0);
  const d1 = scale(sub(points[middle + 1]!, points[middle]!), 1 / h1);
  if (at < middle) return add(scale(d0, (2 * h0 + h1) / (h0 + h1)), scale(d1, -h0 / (h0 + h1)));
  if (at > middle) return add(scale(d0, -h1 / (h0 + h1)), scale(d1, (h0 + 2 * h1) / (h0 + h1)));
  return add(scale(d0, h1 / (h0 + h1)), scale(d1, h0 / (h0 + h1)));
}

/** One Catmull-Rom segment, from the second to the third of four points, with the local parameter u in [0, 1]. */
export type CatmullRomSegment = {
  readonly point: (u: number) => Point;
  /** The derivative with respect to u at u = 0. */
  readonly startTangent: Point;
  /** The derivative with respect to u at u = 1. */
  readonly endTangent: Point;
};

/**
 * The Catmull-Rom segment between the second and the third of four points.
 *
 * @throws RangeError as `catmullRom`, and unless there are exactly four points.
 */
export function catmullRomSegment(points: readonly Point[], alpha: number): CatmullRomSegment {
  if (points.length !== 4) throw new RangeError(`points: expected 4 points, got ${points.length}`);
  const { nodes, tangents } = catmullRom(points, alpha);
  const h = nodes[2]! - nodes[1]!;
  const startTangent = scale(tangents[1]!, h);
  const endTangent = scale(tangents[2]!, h);
  return {
    point: (u) => hermitePoint(points[1]!, startTangent, endTangent, points[2]!, u),
    startTangent,
    endTangent,
  };
}
