import { hodograph } from "./bezier.ts";
import { checkPoints, checkPositive } from "./check.ts";
import type { Curve } from "./curve.ts";
import { add, distance, dot, norm, type Point, scale, sub } from "./point.ts";

/** A polyline along a curve: ascending parameters and their points. */
export type Polyline = { readonly ts: readonly number[]; readonly points: readonly Point[] };

/** Bisection of one smooth piece at most this often, so that a wild curve ends too. */
const deepest = 24;

/**
 * A polyline from the start to the end of a curve that deviates from it by at most `tolerance`, with more vertices where
 * the curve bends more.
 *
 * A piece is halved until five points inside lie within half the tolerance of its chord; each smooth piece between
 * breaks starts with four pieces. The deviation is thus sampled, not proven; `bezierChordCount` is proven. A wild curve
 * stops after 24 halvings.
 *
 * @throws RangeError if `tolerance` is not positive.
 */
export function flatten(curve: Curve, tolerance: number): Polyline {
  checkPositive("tolerance", tolerance);
  const [a, b] = curve.domain;
  const stops = [a, ...(curve.breaks ?? []), b];
  const ts: number[] = [a];
  const points: Point[] = [curve.point(a)];

  const flattenPiece = (t0: number, p0: Point, t1: number, p1: Point, depth: number): void => {
    if (depth === 0 || isFlat(curve, t0, p0, t1, p1, tolerance / 2)) {
      ts.push(t1);
      points.push(p1);
      return;
    }
    const middle = t0 + (t1 - t0) / 2;
    const point = curve.point(middle);
    flattenPiece(t0, p0, middle, point, depth - 1);
    flattenPiece(middle, point, t1, p1, depth - 1);
  };

  for (let i = 1; i < stops.length; i++) {
    for (let k = 1; k <= 4; k++) {
      const t = k === 4 ? stops[i]! : stops[i - 1]! + ((stops[i]! - stops[i - 1]!) * k) / 4;
      flattenPiece(ts.at(-1)!, points.at(-1)!, t, curve.point(t), deepest);
    }
  }
  return { ts, points };
}

function isFlat(curve: Curve, t0: number, p0: Point, t1: number, p1: Point, tolerance: number): boolean {
  for (const part of [0.5, 0.25, 0.75, 0.1, 0.9]) {
    if (distanceToSegment(curve.point(t0 + part * (t1 - t0)), p0, p1) > tolerance) return false;
  }
  return true;
}

/** The distance of a point from the straight segment between a and b. */
export function distanceToSegment(point: Point, a: Point, b: Point): number {
  const direction = sub(b, a);
  const squared = dot(direction, direction);
  const along = squared === 0 ? 0 : dot(sub(point, a), direction) / squared;
  return distance(point, add(a, scale(direction, Math.min(1, Math.max(0, along)))));
}

/**
 * How many chords over equal parameter steps suffice to stay within `tolerance` of a Bézier curve: a proven bound.
 *
 * A chord over a step h deviates by at most h²/8 · max ‖p″‖, and ‖p″‖ ≤ n(n − 1) · max ‖b_{i+2} − 2b_{i+1} + b_i‖.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or `tolerance` is not
 * positive.
 */
export function bezierChordCount(controlPoints: readonly Point[], tolerance: number): number {
  checkPoints("controlPoints", controlPoints);
  checkPositive("tolerance", tolerance);
  const bend = Math.max(...hodograph(controlPoints, 2).map(norm));
  return Math.max(1, Math.ceil(Math.sqrt(bend / (8 * tolerance))));
}
