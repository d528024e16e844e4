import type { Out } from "./bezier-batch.ts";
import { bernsteinInto, highestDegree, unitNormalInto } from "./patch-weights.ts";
import type { Point } from "./point.ts";

/*
 * Bézier patches in space on flat coordinates, for everything tessellated. A net of degrees m, n has control point c_ij
 * at 3·(i·(n + 1) + j). The readable form of the same is `patchPoint`.
 */

/** The coordinates of a net's points one after another, row by row. */
export function toFlatNet(net: readonly (readonly Point[])[]): Float64Array {
  return Float64Array.from(net.flat(2));
}

/** Reused from call to call: weights along u and v and their derivatives, up to this degree. */
const weightsU = new Float64Array(highestDegree + 1);
const weightsV = new Float64Array(highestDegree + 1);
const slopesU = new Float64Array(highestDegree + 1);
const slopesV = new Float64Array(highestDegree + 1);

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
  let x = 0;
  let y = 0;
  let z = 0;
  let c = 0;
  for (let i = 0; i <= m; i++) {
    let rx = 0;
    let ry = 0;
    let rz = 0;
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
  const [a, b] = [tangentU, tangentV];
  return unitNormalInto(out, at, a[0]!, a[1]!, a[2]!, b[0]!, b[1]!, b[2]!, 0);
}
