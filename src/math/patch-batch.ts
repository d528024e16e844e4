import type { Out } from "./bezier-batch.ts";
import { bezierPatch } from "./bezier-patch.ts";
import { checkInteger } from "./check.ts";
import type { Point } from "./point.ts";
import { limitNormal } from "./surface-normal.ts";
import { relativeZero } from "./tangent.ts";

/*
 * Bézier patches in space on flat coordinates, for everything tessellated. A net of degrees m, n has control point c_ij
 * at 3·(i·(n + 1) + j). The readable form of the same is `patchPoint`.
 */

/** The coordinates of a net's points one after another, row by row. */
export function toFlatNet(net: readonly (readonly Point[])[]): Float64Array {
  return Float64Array.from(net.flat(2));
}

/** Reused from call to call: weights along u and v and their derivatives, up to this degree. */
const highest = 64;
const weightsU = new Float64Array(highest + 1);
const weightsV = new Float64Array(highest + 1);
const slopesU = new Float64Array(highest + 1);
const slopesV = new Float64Array(highest + 1);

/** Writes B_0^n(t) … B_n^n(t) and, if asked for, their derivatives, by B_i^r = (1 − t)·B_i^{r−1} + t·B_{i−1}^{r−1}. */
function bernsteinInto(weights: Float64Array, n: number, t: number, slopes?: Float64Array): void {
  const s = 1 - t;
  weights[0] = 1;
  for (let r = 1; r <= n; r++) {
    if (slopes && r === n) differencesInto(slopes, weights, n);
    let carried = 0;
    for (let i = 0; i < r; i++) {
      const old = weights[i]!;
      weights[i] = carried + s * old;
      carried = t * old;
    }
    weights[r] = carried;
  }
  if (slopes && n === 0) slopes[0] = 0;
}

/** d/dt B_i^n = n·(B_{i−1}^{n−1} − B_i^{n−1}) from the weights of degree n − 1. */
function differencesInto(slopes: Float64Array, weights: Float64Array, n: number): void {
  slopes[0] = -n * weights[0]!;
  for (let i = 1; i < n; i++) slopes[i] = n * (weights[i - 1]! - weights[i]!);
  slopes[n] = n * weights[n - 1]!;
}

/** Writes Σ_i Σ_j a_i · b_j · c_ij to `out` from index `at` on. */
function combineInto(
  out: Out,
  at: number,
  net: ArrayLike<number>,
  m: number,
  n: number,
  a: Float64Array,
  b: Float64Array,
): void {
  let [x, y, z] = [0, 0, 0];
  let c = 0;
  for (let i = 0; i <= m; i++) {
    let [rx, ry, rz] = [0, 0, 0];
    for (let j = 0; j <= n; j++) {
      const weight = b[j]!;
      rx += weight * net[c]!;
      ry += weight * net[c + 1]!;
      rz += weight * net[c + 2]!;
      c += 3;
    }
    const weight = a[i]!;
    x += weight * rx;
    y += weight * ry;
    z += weight * rz;
  }
  out[at] = x;
  out[at + 1] = y;
  out[at + 2] = z;
}

/**
 * Writes the point S(u, v) of a Bézier patch of degrees m, n ≤ 64 to `out` from index `at` on. Allocates nothing and
 * checks nothing.
 */
export function patchPointInto(
  out: Out,
  net: ArrayLike<number>,
  m: number,
  n: number,
  u: number,
  v: number,
  at = 0,
): void {
  bernsteinInto(weightsU, m, u);
  bernsteinInto(weightsV, n, v);
  combineInto(out, at, net, m, n, weightsU, weightsV);
}

const tangentU = new Float64Array(3);
const tangentV = new Float64Array(3);

/**
 * Writes the unit normal of a Bézier patch of degrees m, n ≤ 64 to `out` from index `at` on.
 *
 * @returns false, and writes zeros, where S_u × S_v vanishes: a tangent is zero or the sine of their angle below 1e-10
 * (a caller that expects collapsed edges asks `limitNormal` then).
 */
export function patchNormalInto(
  out: Out,
  net: ArrayLike<number>,
  m: number,
  n: number,
  u: number,
  v: number,
  at = 0,
): boolean {
  bernsteinInto(weightsU, m, u, slopesU);
  bernsteinInto(weightsV, n, v, slopesV);
  combineInto(tangentU, 0, net, m, n, slopesU, weightsV);
  combineInto(tangentV, 0, net, m, n, weightsU, slopesV);
  return unitNormalInto(out, at, tangentU, tangentV, 0);
}

/** Writes the normalized product a × b; zeros, and false, if one is shorter than `zero` or they are parallel. */
function unitNormalInto(out: Out, at: number, a: Float64Array, b: Float64Array, zero: number): boolean {
  const x = a[1]! * b[2]! - a[2]! * b[1]!;
  const y = a[2]! * b[0]! - a[0]! * b[2]!;
  const z = a[0]! * b[1]! - a[1]! * b[0]!;
  const aa = a[0]! * a[0]! + a[1]! * a[1]! + a[2]! * a[2]!;
  const bb = b[0]! * b[0]! + b[1]! * b[1]! + b[2]! * b[2]!;
  const length = Math.sqrt(x * x + y * y + z * z);
  const regular = aa > zero * zero && bb > zero * zero && length > relativeZero * Math.sqrt(aa * bb);
  const factor = regular ? 1 / length : 0;
  out[at] = x * factor;
  out[at + 1] = y * factor;
  out[at + 2] = z * factor;
  return regular;
}

/** Writes positions and, if a place for them is given, unit normals of a flat net; see `patchTessellator`. */
export type Tessellate = (
  net: ArrayLike<number>,
  positions: Float32Array | Float64Array,
  normals?: Float32Array | Float64Array,
) => void;

/**
 * A function that samples Bézier patches of degrees m, n on a grid of (stepsU + 1) × (stepsV + 1) points.
 *
 * The Bernstein weights of the grid are computed once; every call then only combines them with a net, so that a dragged
 * control point costs no more than the sums. Sample (a, b) at u = a/stepsU, v = b/stepsV has its coordinates at
 * 3·(a·(stepsV + 1) + b). On collapsed edges the limit of the normal is written (see `limitNormal`), zeros where there
 * is none.
 *
 * @throws RangeError if a degree or a number of steps is not a whole number in range; when called, if the net or the
 * place for the results has the wrong length.
 */
export function patchTessellator(m: number, n: number, stepsU: number, stepsV: number): Tessellate {
  checkInteger("m", m, 0, highest);
  checkInteger("n", n, 0, highest);
  const alongU = table(m, stepsU, "stepsU");
  const alongV = table(n, stepsV, "stepsV");
  const columns = n + 1;
  // The control points of the curve at the current u, and their derivatives in u.
  const q = new Float64Array(3 * columns);
  const dq = new Float64Array(3 * columns);
  const room = 3 * (stepsU + 1) * (stepsV + 1);

  return (net, positions, normals) => {
    checkLength("net", net, 3 * (m + 1) * columns, true);
    checkLength("positions", positions, room);
    if (normals) checkLength("normals", normals, room);
    const zero = normals ? relativeZero * longestTangent(net, m, n) : 0;
    for (let a = 0, at = 0; a <= stepsU; a++) {
      rowInto(q, net, m, alongU.weights, a);
      if (normals) rowInto(dq, net, m, alongU.slopes, a);
      for (let b = 0; b <= stepsV; b++, at += 3) {
        curveInto(positions, at, q, alongV.weights, b * columns, columns);
        if (!normals) continue;
        curveInto(tangentU, 0, dq, alongV.weights, b * columns, columns);
        curveInto(tangentV, 0, q, alongV.slopes, b * columns, columns);
        if (!unitNormalInto(normals, at, tangentU, tangentV, zero)) {
          const limit = limitNormal(bezierPatch(fromFlatNet(net, m, n)), a / stepsU, b / stepsV);
          if (limit) for (let axis = 0; axis < 3; axis++) normals[at + axis] = limit[axis]!;
        }
      }
    }
  };
}

type Table = { readonly weights: Float64Array; readonly slopes: Float64Array };

/** The Bernstein polynomials of a degree and their derivatives at 0, 1/steps, …, 1, one row of n + 1 a parameter. */
function table(n: number, steps: number, name: string): Table {
  checkInteger(name, steps, 1);
  const weights = new Float64Array((n + 1) * (steps + 1));
  const slopes = new Float64Array((n + 1) * (steps + 1));
  for (let k = 0; k <= steps; k++) {
    bernsteinInto(weightsU, n, k / steps, slopesU);
    weights.set(weightsU.subarray(0, n + 1), k * (n + 1));
    slopes.set(slopesU.subarray(0, n + 1), k * (n + 1));
  }
  return { weights, slopes };
}

/** Writes the combination of the net's rows with row `k` of a table. */
function rowInto(
  row: Float64Array,
  net: ArrayLike<number>,
  m: number,
  weights: Float64Array,
  k: number,
): void {
  const width = row.length;
  for (let c = 0; c < width; c++) {
    let sum = 0;
    for (let i = 0; i <= m; i++) sum += weights[k * (m + 1) + i]! * net[i * width + c]!;
    row[c] = sum;
  }
}

/** Writes the combination of points with `count` weights from index `first` on. */
function curveInto(
  out: Out,
  at: number,
  points: Float64Array,
  weights: Float64Array,
  first: number,
  count: number,
): void {
  let [x, y, z] = [0, 0, 0];
  for (let j = 0; j < count; j++) {
    const weight = weights[first + j]!;
    x += weight * points[3 * j]!;
    y += weight * points[3 * j + 1]!;
    z += weight * points[3 * j + 2]!;
  }
  out[at] = x;
  out[at + 1] = y;
  out[at + 2] = z;
}

function longestTangent(net: ArrayLike<number>, m: number, n: number): number {
  return bezierPatch(fromFlatNet(net, m, n)).speed!;
}

function fromFlatNet(net: ArrayLike<number>, m: number, n: number): Point[][] {
  return Array.from({ length: m + 1 }, (_, i) =>
    Array.from({ length: n + 1 }, (_, j) => {
      const c = 3 * (i * (n + 1) + j);
      return [net[c]!, net[c + 1]!, net[c + 2]!];
    }),
  );
}

function checkLength(name: string, list: ArrayLike<number>, length: number, exact = false): void {
  if (list.length < length || (exact && list.length > length)) {
    throw new RangeError(
      `${name}: expected ${exact ? "" : "at least "}${length} coordinates, got ${list.length}`,
    );
  }
}
