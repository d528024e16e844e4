import { bernsteinAll } from "./bernstein.ts";
import { checkInteger } from "./check.ts";
import { relativeZero } from "./tangent.ts";

/** Writes Gaussian and mean curvatures of a flat net at all places of a grid; see `patchCurvatureSampler`. */
export type SampleCurvature = (net: ArrayLike<number>, gaussian: Float64Array, mean?: Float64Array) => void;

/**
 * A function that computes the curvatures of Bézier patches of degrees m, n ≥ 1 on the grid of `patchTessellator`:
 * (stepsU + 1) × (stepsV + 1) places, row by row. The readable form for one place is `surfaceCurvature`.
 *
 * Where S_u × S_v vanishes (a tangent of zero length, or an angle with a sine below 1e-10) it writes NaN.
 *
 * @throws RangeError if a degree or a number of steps is not a whole number ≥ 1; when called, if the net has the wrong
 * length.
 */
export function patchCurvatureSampler(m: number, n: number, stepsU: number, stepsV: number): SampleCurvature {
  for (const [name, value] of Object.entries({ m, n, stepsU, stepsV })) checkInteger(name, value, 1);
  const alongU = derivativeWeights(m, stepsU);
  const alongV = derivativeWeights(n, stepsV);
  const columns = n + 1;
  // The control points of the curve at the current u, and their first and second derivatives in u.
  const curves = [0, 1, 2].map(() => new Float64Array(3 * columns));
  const [s, su, sv, suu, suv, svv] = Array.from({ length: 6 }, () => new Float64Array(3)) as Six;

  return (net, gaussian, mean) => {
    if (net.length !== 3 * (m + 1) * columns) {
      throw new RangeError(`net: expected ${3 * (m + 1) * columns} coordinates, got ${net.length}`);
    }
    for (let a = 0, at = 0; a <= stepsU; a++) {
      for (let r = 0; r < 3; r++) combine(curves[r]!, net, alongU[r]!, a * (m + 1), m + 1, 3 * columns);
      for (let b = 0; b <= stepsV; b++, at++) {
        const sum = (out: Float64Array, k: number, l: number) =>
          combine(out, curves[k]!, alongV[l]!, b * columns, columns, 3);
        sum(s, 0, 0);
        sum(su, 1, 0);
        sum(sv, 0, 1);
        sum(suu, 2, 0);
        sum(suv, 1, 1);
        sum(svv, 0, 2);
        const nx = su[1]! * sv[2]! - su[2]! * sv[1]!;
        const ny = su[2]! * sv[0]! - su[0]! * sv[2]!;
        const nz = su[0]! * sv[1]! - su[1]! * sv[0]!;
        const [E, F, G] = [dot(su, su), dot(su, sv), dot(sv, sv)];
        const area = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (!(area > relativeZero * Math.sqrt(E * G)) || E === 0 || G === 0) {
          gaussian[at] = Number.NaN;
          if (mean) mean[at] = Number.NaN;
          continue;
        }
        const along = (w: Float64Array) => (w[0]! * nx + w[1]! * ny + w[2]! * nz) / area;
        const [L, M, N] = [along(suu), along(suv), along(svv)];
        const det = area * area;
        gaussian[at] = (L * N - M * M) / det;
        if (mean) mean[at] = (E * N - 2 * F * M + G * L) / (2 * det);
      }
    }
  };
}

type Six = [Float64Array, Float64Array, Float64Array, Float64Array, Float64Array, Float64Array];

/** For the derivatives of order 0, 1, 2: their weights of the control points at 0, 1/steps, …, 1. */
function derivativeWeights(n: number, steps: number): readonly Float64Array[] {
  return [0, 1, 2].map((r) => {
    const weights = new Float64Array((n + 1) * (steps + 1));
    if (r > n) return weights;
    const factor = r === 0 ? 1 : r === 1 ? n : n * (n - 1);
    const signs = [[1], [-1, 1], [1, -2, 1]][r]!;
    for (let k = 0; k <= steps; k++) {
      bernsteinAll(n - r, k / steps).forEach((b, i) => {
        signs.forEach((sign, j) => {
          weights[k * (n + 1) + i + j]! += factor * sign * b;
        });
      });
    }
    return weights;
  });
}

/** Writes Σ weights[first + i] · points[i], each "point" being `width` numbers. */
function combine(
  out: Float64Array,
  points: ArrayLike<number>,
  weights: Float64Array,
  first: number,
  count: number,
  width: number,
): void {
  for (let c = 0; c < width; c++) {
    let sum = 0;
    for (let i = 0; i < count; i++) sum += weights[first + i]! * points[i * width + c]!;
    out[c] = sum;
  }
}

function dot(a: Float64Array, b: Float64Array): number {
  return a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
}
