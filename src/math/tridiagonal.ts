import { type Point, scale } from "./point.ts";

/**
 * A system of n linear equations, each of which knows only its own unknown and that unknown's two neighbours:
 *
 * below[r] · x[r−1] + diagonal[r] · x[r] + above[r] · x[r+1] = right[r],  r = 0 … n−1.
 *
 * The unknowns and the right sides are points. below[0] and above[n−1] would reach out of the matrix: they are the
 * corners of a cyclic system, where the neighbours of the first and the last unknown are each other, and 0 otherwise.
 */
export type TridiagonalSystem = {
  readonly below: readonly number[];
  readonly diagonal: readonly number[];
  readonly above: readonly number[];
  readonly right: readonly Point[];
};

/**
 * Solves a tridiagonal system by elimination without pivots (Thomas' algorithm), in time linear in n.
 *
 * Stable for diagonally dominant systems, such as those of cubic splines; the corners below[0] and above[n−1] are not
 * looked at (see `solveCyclic`). A vanishing pivot gives no finite result.
 */
export function solveTridiagonal({ below, diagonal, above, right }: TridiagonalSystem): Point[] {
  const d = [...diagonal];
  const x = [...right];
  for (let r = 1; r < x.length; r++) {
    const factor = below[r]! / d[r - 1]!;
    d[r] = d[r]! - factor * above[r - 1]!;
    x[r] = x[r]!.map((value, axis) => value - factor * x[r - 1]![axis]!);
  }
  for (let r = x.length - 1; r >= 0; r--) {
    const next = x[r + 1];
    x[r] = x[r]!.map((value, axis) => (value - (next ? above[r]! * next[axis]! : 0)) / d[r]!);
  }
  return x;
}

/**
 * Solves a cyclic tridiagonal system, corners included, in time linear in n.
 *
 * The cyclic matrix is a tridiagonal one plus a matrix of rank one, u · vᵀ; two tridiagonal solutions are put together
 * by the Sherman-Morrison formula.
 */
export function solveCyclic(system: TridiagonalSystem): Point[] {
  const { below, diagonal, above, right } = system;
  const last = right.length - 1;
  if (last === 0) return [scale(right[0]!, 1 / (below[0]! + diagonal[0]! + above[0]!))];
  const gamma = -diagonal[0]!;
  const u = right.map((_, r) => [r === 0 ? gamma : r === last ? above[last]! : 0]);
  const d = [...diagonal];
  d[0] = d[0]! - gamma;
  d[last] = d[last]! - (above[last]! * below[0]!) / gamma;
  const y = solveTridiagonal({ below, diagonal: d, above, right });
  const z = solveTridiagonal({ below, diagonal: d, above, right: u });
  const corner = below[0]! / gamma;
  const share = 1 / (1 + z[0]![0]! + corner * z[last]![0]!);
  return y.map((point, r) =>
    point.map((value, axis) => value - z[r]![0]! * share * (y[0]![axis]! + corner * y[last]![axis]!)),
  );
}
