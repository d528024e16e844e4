import { checkAscending, checkPoints, checkSameLength } from "./check.ts";
import type { Curve } from "./curve.ts";
import { findInterval } from "./find-interval.ts";
import { hermiteCubicBasis, hermiteToBezier } from "./hermite-segment.ts";
import { dot, norm, type Point, scale, sub } from "./point.ts";

/** A piecewise cubic curve given by points and tangents (first derivatives) at ascending nodes; C¹ at every node. */
export type HermiteSpline = Curve & {
  readonly nodes: readonly number[];
  readonly points: readonly Point[];
  readonly tangents: readonly Point[];
};

/**
 * The Hermite spline: between two nodes the cubic that meets both points and both tangents.
 *
 * Local: a point or tangent acts on the two segments that meet in it. Tangents are derivatives with respect to the
 * global t; on a segment of length h the local ones are h times as long. At the nodes the points are met exactly; the
 * second derivative may jump there.
 *
 * @throws RangeError if there are fewer than two nodes, the nodes do not ascend, the lists do not fit, dimensions
 * differ or a number is not finite.
 */
export function hermiteSpline(
  nodes: readonly number[],
  points: readonly Point[],
  tangents: readonly Point[],
): HermiteSpline {
  checkAscending("nodes", nodes, 2);
  const dimension = checkPoints("points", points);
  checkPoints("tangents", tangents, 1, dimension);
  checkSameLength("points", points, "nodes", nodes);
  checkSameLength("tangents", tangents, "nodes", nodes);
  const derivative = (t: number, r = 1): Point => {
    const i = findInterval(nodes, t);
    const h = nodes[i + 1]! - nodes[i]!;
    const [h0, h1, h2, h3] = hermiteCubicBasis((t - nodes[i]!) / h, r);
    const [p0, m0, m1, p1] = [points[i]!, tangents[i]!, tangents[i + 1]!, points[i + 1]!];
    return p0.map((x, axis) => {
      const local = h0 * x + h1 * h * m0[axis]! + h2 * h * m1[axis]! + h3 * p1[axis]!;
      return local / h ** r;
    });
  };
  const domain = [nodes[0]!, nodes.at(-1)!] as const;
  const data = { nodes, points, tangents, dimension, derivative };
  return { ...data, ...restricted(nodes, derivative, dimension, domain, speedOf(nodes, points, tangents)) };
}

/** The curve over a part of the nodes' interval: what a split leaves. */
function restricted(
  nodes: readonly number[],
  derivative: Curve["derivative"],
  dimension: number,
  [a, b]: readonly [number, number],
  speed: number,
): Curve {
  return {
    dimension,
    domain: [a, b],
    point: (t) => derivative(t, 0),
    derivative,
    breaks: nodes.filter((t) => t > a && t < b),
    speed,
    split: (t) => [
      restricted(nodes, derivative, dimension, [a, t], speed),
      restricted(nodes, derivative, dimension, [t, b], speed),
    ],
  };
}

/** The longest leg of the hodographs: no derivative of a Bézier curve is longer. */
function speedOf(nodes: readonly number[], points: readonly Point[], tangents: readonly Point[]): number {
  let longest = 0;
  for (let i = 0; i + 1 < nodes.length; i++) {
    const h = nodes[i + 1]! - nodes[i]!;
    const [m0, m1] = [tangents[i]!, tangents[i + 1]!];
    // The inner leg of the Bézier polygon, as a derivative: 3·(c₂ − c₁)/h = 3·(p₁ − p₀)/h − m₀ − m₁.
    const inner = points[i]!.map((x, axis) => (3 * (points[i + 1]![axis]! - x)) / h - m0[axis]! - m1[axis]!);
    longest = Math.max(longest, norm(m0), norm(inner), norm(m1));
  }
  return longest;
}

/** The Bézier control points of the segment from node i to node i + 1. */
export function segmentToBezier(
  { nodes, points, tangents }: Pick<HermiteSpline, "nodes" | "points" | "tangents">,
  i: number,
): [Point, Point, Point, Point] {
  const h = nodes[i + 1]! - nodes[i]!;
  return hermiteToBezier(points[i]!, scale(tangents[i]!, h), scale(tangents[i + 1]!, h), points[i + 1]!);
}

/** The Bézier control points of all segments of a Hermite spline, in order: what a drawing needs. */
export function splineToBezier(spline: HermiteSpline): [Point, Point, Point, Point][] {
  return spline.nodes.slice(1).map((_, i) => segmentToBezier(spline, i));
}

/** The second derivatives at both ends of the segment from node i to node i + 1, from within the segment. */
export function segmentMoments(spline: HermiteSpline, i: number): [Point, Point] {
  const { nodes, points, tangents } = spline;
  const h = nodes[i + 1]! - nodes[i]!;
  const chord = scale(sub(points[i + 1]!, points[i]!), 1 / h);
  const [m0, m1] = [tangents[i]!, tangents[i + 1]!];
  const start = chord.map((d, axis) => (6 * d - 4 * m0[axis]! - 2 * m1[axis]!) / h);
  const end = chord.map((d, axis) => (2 * m0[axis]! + 4 * m1[axis]! - 6 * d) / h);
  return [start, end];
}

/**
 * The integral ∫ |S″(t)|² dt of a Hermite spline, exactly: S″ is linear on every segment.
 *
 * Of all C² functions through the same values the natural cubic spline has the least. It is the bending energy of a
 * lath for small slopes only, where |S″| stands for the curvature.
 */
export function bendingEnergy(spline: HermiteSpline): number {
  let energy = 0;
  for (let i = 0; i + 1 < spline.nodes.length; i++) {
    const h = spline.nodes[i + 1]! - spline.nodes[i]!;
    const [start, end] = segmentMoments(spline, i);
    energy += (h / 3) * (dot(start, start) + dot(start, end) + dot(end, end));
  }
  return energy;
}
