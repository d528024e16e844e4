/*
 * What the batch forms of patches share; not part of the public face.
 */
import type { Out } from "./bezier-batch.ts";
import { relativeZero } from "./tangent.ts";

/** The highest degree of a patch in batch forms. */
export const highestDegree = 64;

/**
 * Writes B_0^n(t) … B_n^n(t) and, if asked for, their derivatives, by B_i^r = (1 − t)·B_i^{r−1} + t·B_{i−1}^{r−1};
 * the cubic ones in full.
 */
export function bernsteinInto(weights: Float64Array, n: number, t: number, slopes?: Float64Array): void {
  const s = 1 - t;
  if (n === 3) {
    weights[0] = s * s * s;
    weights[1] = 3 * s * s * t;
    weights[2] = 3 * s * t * t;
    weights[3] = t * t * t;
    if (!slopes) return;
    slopes[0] = -3 * s * s;
    slopes[1] = 3 * s * (s - 2 * t);
    slopes[2] = 3 * t * (2 * s - t);
    slopes[3] = 3 * t * t;
    return;
  }
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

/** Writes the normalized product u × v; zeros, and false, if one is shorter than `zero` or they are parallel. */
export function unitNormalInto(
  out: Out,
  at: number,
  ux: number,
  uy: number,
  uz: number,
  vx: number,
  vy: number,
  vz: number,
  zero: number,
): boolean {
  const x = uy * vz - uz * vy;
  const y = uz * vx - ux * vz;
  const z = ux * vy - uy * vx;
  const uu = ux * ux + uy * uy + uz * uz;
  const vv = vx * vx + vy * vy + vz * vz;
  const length = Math.sqrt(x * x + y * y + z * z);
  const regular = uu > zero * zero && vv > zero * zero && length > relativeZero * Math.sqrt(uu * vv);
  out[at] = regular ? x / length : 0;
  out[at + 1] = regular ? y / length : 0;
  out[at + 2] = regular ? z / length : 0;
  return regular;
}
