/**
 * A point or a vector: its Cartesian coordinates, any dimension from 1 up.
 *
 * The functions of this file expect points of one dimension (see `checkPoints`) and return new ones.
 */
export type Point = readonly number[];

/** The sum a + b, coordinate by coordinate. */
export function add(a: Point, b: Point): Point {
  return a.map((x, i) => x + b[i]!);
}

/** The vector a − b, which leads from b to a. */
export function sub(a: Point, b: Point): Point {
  return a.map((x, i) => x - b[i]!);
}

/** The vector `factor` · a. */
export function scale(a: Point, factor: number): Point {
  return a.map((x) => factor * x);
}

/**
 * The point (1 − t)·a + t·b on the line through a and b.
 *
 * For t = 0 and t = 1 it is a and b exactly; t outside [0, 1] continues the line. This form cannot overflow
 * within [0, 1], unlike a + t·(b − a).
 */
export function lerp(a: Point, b: Point, t: number): Point {
  return a.map((x, i) => (1 - t) * x + t * b[i]!);
}

/** The affine or linear combination Σ weights[i] · points[i]; at least one point. */
export function combine(weights: readonly number[], points: readonly Point[]): Point {
  return points[0]!.map((_, axis) => points.reduce((sum, point, i) => sum + weights[i]! * point[axis]!, 0));
}

/** The scalar product a · b. */
export function dot(a: Point, b: Point): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i]! * b[i]!;
  return sum;
}

/** The Euclidean length of a vector; it neither overflows nor underflows on the way. */
export function norm(a: Point): number {
  const squared = dot(a, a);
  return squared > 1e-280 && squared < 1e280 ? Math.sqrt(squared) : Math.hypot(...a);
}

/** The Euclidean distance of two points. */
export function distance(a: Point, b: Point): number {
  return norm(sub(a, b));
}

/** The vector of length 1 in the direction of a, or `null` for the zero vector, which has no direction. */
export function normalize(a: Point): Point | null {
  const largest = a.reduce((max, x) => Math.max(max, Math.abs(x)), 0);
  if (largest === 0) return null;
  // Two steps, so that 1 / length cannot overflow for a tiny vector.
  const scaled = a.map((x) => x / largest);
  return scale(scaled, 1 / norm(scaled));
}

/** The vector product a × b of two vectors in space. */
export function cross(a: Point, b: Point): Point {
  return [a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!];
}

/** The determinant of two vectors in the plane: positive if b lies to the left of a (y up). */
export function cross2(a: Point, b: Point): number {
  return a[0]! * b[1]! - a[1]! * b[0]!;
}

/**
 * The area of the parallelogram spanned by two vectors of any dimension, |a × b| in space and |det| in the plane.
 *
 * It is summed from the 2×2 minors (Lagrange's identity), which keeps its accuracy for nearly parallel vectors.
 */
export function parallelogramArea(a: Point, b: Point): number {
  const minors: number[] = [0];
  for (let i = 0; i < a.length; i++) {
    for (let j = i + 1; j < a.length; j++) minors.push(a[i]! * b[j]! - a[j]! * b[i]!);
  }
  return norm(minors);
}

/** The angle between two vectors in radians, 0 … π, or `null` if one of them is the zero vector. */
export function angleBetween(a: Point, b: Point): number | null {
  const u = normalize(a);
  const v = normalize(b);
  return u && v && Math.atan2(parallelogramArea(u, v), dot(u, v));
}

/** The zero vector of a dimension. */
export function zero(dimension: number): Point {
  return new Array<number>(dimension).fill(0);
}
