import { checkAscending, checkPoint, checkPositive } from "./check.ts";
import { curvatureVector } from "./curvature.ts";
import type { Curve } from "./curve.ts";
import { angleBetween, cross, dot, norm, normalize, type Point, scale, sub } from "./point.ts";
import { unitTangent } from "./tangent.ts";

/** An orthonormal frame of a curve in space. */
export type Frame = {
  readonly point: Point;
  readonly tangent: Point;
  readonly normal: Point;
  readonly binormal: Point;
};

/**
 * The Frenet frame of a curve in space at t: unit tangent, principal normal (towards the centre of curvature) and
 * binormal = tangent × normal.
 *
 * `null` where there is none: the first derivative vanishes, or the curvature does (below 1e-10 over the curve's length),
 * where the principal normal may jump to the other side.
 *
 * @throws RangeError if the curve does not lie in space.
 */
export function frenetFrame(curve: Curve, t: number): Frame | null {
  checkSpace(curve);
  const across = curvatureVector(curve, t);
  const tangent = unitTangent(curve, t);
  if (!across || !tangent) return null;
  const length = norm(curve.derivative(t)) * (curve.domain[1] - curve.domain[0]);
  const normal = normalize(across);
  if (!normal || norm(across) * length <= 1e-10) return null;
  return { point: curve.point(t), tangent, normal, binormal: cross(tangent, normal) };
}

/**
 * The frame of a plane curve at t: unit tangent and unit normal to its left, or `null` where the curve stands still.
 *
 * Where only the first derivative vanishes the tangent is the one-sided limit, see `unitTangent`.
 *
 * @throws RangeError if the curve does not lie in the plane.
 */
export function planeFrame(curve: Curve, t: number): { point: Point; tangent: Point; normal: Point } | null {
  if (curve.dimension !== 2) {
    throw new RangeError(`curve: expected a curve in 2 dimensions, got ${curve.dimension}`);
  }
  const tangent = unitTangent(curve, t);
  return tangent && { point: curve.point(t), tangent, normal: [-tangent[1]!, tangent[0]!] };
}

/**
 * Rotation-minimising frames of a curve in space at ascending parameters: each normal is carried along without turning
 * about the tangent.
 *
 * `start` is a wish for the first normal (made perpendicular to the tangent; by default across the coordinate axis
 * farthest from the tangent). The double reflection method is repeated with halved steps until the last normal turns by
 * less than `accuracy` (radians), at most ten times. Where the curve stands still the tangent before is kept.
 *
 * Source: W. Wang, B. Jüttler, D. Zheng, Y. Liu, Computation of rotation minimizing frames.
 *
 * @throws RangeError if the curve or `start` does not lie in space, `ts` is empty or not strictly ascending, `accuracy` is
 * not positive, or the curve stands still at the first parameter.
 */
export function rotationMinimisingFrames(
  curve: Curve,
  ts: readonly number[],
  accuracy: number,
  start?: Point,
): Frame[] {
  checkSpace(curve);
  checkAscending("ts", ts);
  checkPositive("accuracy", accuracy);
  if (start) checkPoint("start", start, 3);
  const tangent = unitTangent(curve, ts[0]!);
  if (!tangent)
    throw new RangeError(`curve: expected a direction at ts[0] = ${ts[0]}, but it stands still there`);
  const normal = perpendicular(tangent, start) ?? perpendicular(tangent)!;
  const first: Frame = { point: curve.point(ts[0]!), tangent, normal, binormal: cross(tangent, normal) };
  let frames = transport(curve, ts, first, 1);
  for (let steps = 2; steps <= 1024; steps *= 2) {
    const finer = transport(curve, ts, first, steps);
    const turned = angleBetween(frames.at(-1)!.normal, finer.at(-1)!.normal)!;
    frames = finer;
    if (turned <= accuracy) break;
  }
  return frames;
}

/** Carries a frame through all parameters with `steps` reflections between two. */
function transport(curve: Curve, ts: readonly number[], first: Frame, steps: number): Frame[] {
  const frames = [first];
  for (let i = 1; i < ts.length; i++) {
    let frame = frames[i - 1]!;
    for (let k = 1; k <= steps; k++) {
      frame = nextFrame(curve, frame, ts[i - 1]! + ((ts[i]! - ts[i - 1]!) * k) / steps);
    }
    frames.push(frame);
  }
  return frames;
}

/**
 * Reflects a frame twice: in the plane between the two points, then in the plane that takes the reflected tangent to the
 * new one. Two reflections make a rotation.
 */
function nextFrame(curve: Curve, frame: Frame, t: number): Frame {
  const point = curve.point(t);
  const tangent = unitTangent(curve, t) ?? frame.tangent;
  const between = sub(point, frame.point);
  const halfway = reflect(frame.tangent, between);
  const reflected = reflect(reflect(frame.normal, between), sub(tangent, halfway));
  // Only rounding is left to remove: reflections keep the right angle.
  const normal = perpendicular(tangent, reflected)!;
  return { point, tangent, normal, binormal: cross(tangent, normal) };
}

/** The mirror image of a vector in the plane through 0 across `axis`; the vector itself for the zero axis. */
function reflect(vector: Point, axis: Point): Point {
  const squared = dot(axis, axis);
  return squared === 0 ? vector : sub(vector, scale(axis, (2 * dot(axis, vector)) / squared));
}

/** The unit vector across `tangent` nearest to `wish`, by default to the axis farthest from the tangent. */
function perpendicular(tangent: Point, wish?: Point): Point | null {
  const sizes = tangent.map(Math.abs);
  const farthest = sizes.indexOf(Math.min(...sizes));
  const vector = wish ?? tangent.map((_, axis) => (axis === farthest ? 1 : 0));
  const across = sub(vector, scale(tangent, dot(vector, tangent)));
  return norm(across) <= 1e-10 * norm(vector) ? null : normalize(across);
}

function checkSpace(curve: Curve): void {
  if (curve.dimension !== 3) {
    throw new RangeError(`curve: expected a curve in 3 dimensions, got ${curve.dimension}`);
  }
}
