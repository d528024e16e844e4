import type { Out } from "./bezier-batch.ts";
import { bezierPatch } from "./bezier-patch.ts";
import { checkInteger } from "./check.ts";
import { bernsteinInto, highestDegree, unitNormalInto } from "./patch-weights.ts";
import type { Point } from "./point.ts";
import { limitNormal } from "./surface-normal.ts";
import { relativeZero } from "./tangent.ts";

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
  checkInteger("m", m, 0, highestDegree);
  checkInteger("n", n, 0, highestDegree);
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
        pointInto(positions, at, q, alongV.weights, b);
        if (!normals || tangentNormalInto(normals, at, q, dq, alongV, b, zero)) continue;
        const limit = limitNormal(bezierPatch(fromFlatNet(net, m, n)), a / stepsU, b / stepsV);
        if (limit) for (let axis = 0; axis < 3; axis++) normals[at + axis] = limit[axis]!;
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
    const row = k * (n + 1);
    bernsteinInto(weights.subarray(row), n, k / steps, slopes.subarray(row));
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

/** Writes the combination of the curve's control points `q` with row `b` of a table. */
function pointInto(out: Out, at: number, q: Float64Array, weights: Float64Array, b: number): void {
  let x = 0;
  let y = 0;
  let z = 0;
  for (let c = 0, j = (b * q.length) / 3; c < q.length; c += 3, j++) {
    const weight = weights[j]!;
    x += weight * q[c]!;
    y += weight * q[c + 1]!;
    z += weight * q[c + 2]!;
  }
  out[at] = x;
  out[at + 1] = y;
  out[at + 2] = z;
}

/** Writes the unit normal from the curve's control points and their derivatives; see `unitNormalInto`. */
function tangentNormalInto(
  out: Out,
  at: number,
  q: Float64Array,
  dq: Float64Array,
  { weights, slopes }: Table,
  b: number,
  zero: number,
): boolean {
  let ux = 0;
  let uy = 0;
  let uz = 0;
  let vx = 0;
  let vy = 0;
  let vz = 0;
  for (let c = 0, j = (b * q.length) / 3; c < q.length; c += 3, j++) {
    const weight = weights[j]!;
    const slope = slopes[j]!;
    ux += weight * dq[c]!;
    uy += weight * dq[c + 1]!;
    uz += weight * dq[c + 2]!;
    vx += slope * q[c]!;
    vy += slope * q[c + 1]!;
    vz += slope * q[c + 2]!;
  }
  return unitNormalInto(out, at, ux, uy, uz, vx, vy, vz, zero);
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
