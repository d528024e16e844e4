import { bernstein, binomial } from "./bernstein.ts";

/*
 * Bézier curves on flat coordinates, for everything drawn or tessellated. Control point i has its coordinates at
 * i·d … i·d + d − 1 (d = dimension); points are written in the same way. These functions allocate nothing and check
 * nothing: data come from code that has checked them; coordinates up to 1e280 cannot overflow. The readable form of the
 * same is `bezierPoint`.
 */

/** A list of numbers that can be written: an array or a Float64Array or Float32Array. */
export type Out = { [index: number]: number };

/** The coordinates of points one after another. */
export function toFlat(points: readonly (readonly number[])[]): Float64Array {
  const dimension = points[0]?.length ?? 0;
  const flat = new Float64Array(points.length * dimension);
  for (const [i, point] of points.entries()) flat.set(point, i * dimension);
  return flat;
}

/** The points of flat coordinates; the inverse of `toFlat`. */
export function fromFlat(flat: ArrayLike<number>, dimension: number): number[][] {
  return Array.from({ length: flat.length / dimension }, (_, i) =>
    Array.from({ length: dimension }, (_, axis) => flat[i * dimension + axis]!),
  );
}

/**
 * Writes the point of a Bézier curve at t to `out`, from index `at` on.
 *
 * Any degree n ≥ 0 and any dimension; t in [0, 1] (outside, high degrees lose digits). Cubics use the four Bernstein
 * polynomials, other degrees up to 60 Horner's scheme in t/(1 − t), multiplied out: linear in n. Beyond, where its
 * terms grow too large, the Bernstein polynomials are summed: quadratic in n.
 */
export function bezierPointInto(
  out: Out,
  controlPoints: ArrayLike<number>,
  dimension: number,
  t: number,
  at = 0,
): void {
  const end = controlPoints.length - dimension;
  if (end === 3 * dimension) cubicInto(out, controlPoints, dimension, t, at);
  else if (end <= 60 * dimension) hornerInto(out, controlPoints, dimension, t, at);
  else sumInto(out, controlPoints, dimension, t, at);
}

function cubicInto(out: Out, c: ArrayLike<number>, dimension: number, t: number, at: number): void {
  const s = 1 - t;
  const w0 = s * s * s;
  const w1 = 3 * s * s * t;
  const w2 = 3 * s * t * t;
  const w3 = t * t * t;
  if (dimension === 2) {
    // The most drawn case, without the loop.
    out[at] = w0 * c[0]! + w1 * c[2]! + w2 * c[4]! + w3 * c[6]!;
    out[at + 1] = w0 * c[1]! + w1 * c[3]! + w2 * c[5]! + w3 * c[7]!;
    return;
  }
  for (let axis = 0; axis < dimension; axis++) {
    out[at + axis] =
      w0 * c[axis]! +
      w1 * c[dimension + axis]! +
      w2 * c[2 * dimension + axis]! +
      w3 * c[3 * dimension + axis]!;
  }
}

/** Horner's scheme: from ((b_0·s + n·t·b_1)·s + …)·s + tⁿ·b_n, s = 1 − t, two coordinates at a time. */
function hornerInto(out: Out, c: ArrayLike<number>, dimension: number, t: number, at: number): void {
  const s = 1 - t;
  const n = c.length / dimension - 1;
  const row = binomialRow(n);
  for (let axis = 0; axis < dimension; axis += 2) {
    const both = axis + 1 < dimension ? 1 : 0;
    let power = 1;
    let x = c[axis]!;
    let y = c[axis + both]!;
    for (let i = 1, k = axis + dimension; i <= n; i++, k += dimension) {
      power *= t;
      const weight = row[i]! * power;
      x = x * s + weight * c[k]!;
      y = y * s + weight * c[k + both]!;
    }
    out[at + axis] = x;
    out[at + axis + both] = y;
  }
}

function sumInto(out: Out, c: ArrayLike<number>, dimension: number, t: number, at: number): void {
  const n = c.length / dimension - 1;
  for (let axis = 0; axis < dimension; axis++) out[at + axis] = 0;
  for (let i = 0; i <= n; i++) {
    const weight = bernstein(n, i, t);
    for (let axis = 0; axis < dimension; axis++) out[at + axis]! += weight * c[i * dimension + axis]!;
  }
}

/** Rows of Pascal's triangle, made when first needed. */
const rows: Float64Array[] = [];

function binomialRow(n: number): Float64Array {
  let row = rows[n];
  if (!row) {
    row = Float64Array.from({ length: n + 1 }, (_, i) => binomial(n, i));
    rows[n] = row;
  }
  return row;
}

/** Writes the points of a Bézier curve at all parameters `ts` to `out`, one after another. */
export function bezierPointsInto(
  out: Out,
  controlPoints: ArrayLike<number>,
  dimension: number,
  ts: ArrayLike<number>,
): void {
  if (controlPoints.length === 8 && dimension === 2) {
    planeCubicInto(out, controlPoints, ts);
    return;
  }
  for (let k = 0; k < ts.length; k++) bezierPointInto(out, controlPoints, dimension, ts[k]!, k * dimension);
}

/** The most drawn case, with its eight coordinates kept in variables. */
function planeCubicInto(out: Out, c: ArrayLike<number>, ts: ArrayLike<number>): void {
  const [x0, y0, x1, y1] = [c[0]!, c[1]!, c[2]!, c[3]!];
  const [x2, y2, x3, y3] = [c[4]!, c[5]!, c[6]!, c[7]!];
  for (let k = 0; k < ts.length; k++) {
    const t = ts[k]!;
    const s = 1 - t;
    const w0 = s * s * s;
    const w1 = 3 * s * s * t;
    const w2 = 3 * s * t * t;
    const w3 = t * t * t;
    out[2 * k] = w0 * x0 + w1 * x1 + w2 * x2 + w3 * x3;
    out[2 * k + 1] = w0 * y0 + w1 * y1 + w2 * y2 + w3 * y3;
  }
}

/** Writes `count` + 1 points at equal parameter steps from 0 to 1, ends included; count ≥ 1. */
export function bezierPolylineInto(
  out: Out,
  controlPoints: ArrayLike<number>,
  dimension: number,
  count: number,
): void {
  for (let k = 0; k <= count; k++) bezierPointInto(out, controlPoints, dimension, k / count, k * dimension);
}

/**
 * Writes the first derivative of a Bézier curve at t to `out`, from index `at` on; the zero vector for degree 0.
 *
 * Any degree up to 60 and any dimension; t in [0, 1].
 */
export function bezierDerivativeInto(
  out: Out,
  controlPoints: ArrayLike<number>,
  dimension: number,
  t: number,
  at = 0,
): void {
  const n = controlPoints.length / dimension - 1;
  const row = binomialRow(Math.max(0, n - 1));
  const s = 1 - t;
  for (let axis = 0; axis < dimension; axis++) {
    let power = 1;
    let sum = 0;
    for (let i = 0, k = axis; i < n; i++, k += dimension) {
      sum = sum * s + row[i]! * power * (controlPoints[k + dimension]! - controlPoints[k]!);
      power *= t;
    }
    out[at + axis] = n * sum;
  }
}
