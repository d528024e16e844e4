import { checkNumber } from "./check.ts";
import { combine, type Point } from "./point.ts";

/** A 4×4 matrix as four rows. */
export type Matrix4 = readonly [Row4, Row4, Row4, Row4];
/** Four numbers: a row of a 4×4 matrix, or the powers [t³ t² t 1]. */
export type Row4 = readonly [number, number, number, number];

/** The identity matrix. */
export const identity4: Matrix4 = [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

/** The product A · B. */
export function multiply4(a: Matrix4, b: Matrix4): Matrix4 {
  return a.map((row) => rowTimes4(row, b)) as unknown as Matrix4;
}

/** The row vector `row` · M. */
export function rowTimes4(row: Row4, matrix: Matrix4): Row4 {
  return combine(row, matrix) as unknown as Row4;
}

/** M · G for a geometry vector of four points (or vectors) of one dimension: four rows again. */
export function applyToGeometry(matrix: Matrix4, geometry: readonly Point[]): Point[] {
  return matrix.map((row) => combine(row, geometry));
}

/**
 * The inverse of a 4×4 matrix by Gauss-Jordan elimination with row pivots, or `null` if it has none.
 *
 * "None" means: a pivot is below 10⁻¹² of the largest entry in its row of the original matrix (so the test does not
 * depend on the unit of any row).
 *
 * @throws RangeError if an entry is not finite.
 */
export function invert4(matrix: Matrix4): Matrix4 | null {
  matrix.forEach((row, i) => {
    row.forEach((entry, j) => {
      checkNumber(`matrix[${i}][${j}]`, entry);
    });
  });
  // Each working row is [row of M | row of the identity], divided by the largest entry of the row of M.
  const rows = matrix.map((row, i) => {
    const largest = Math.max(...row.map(Math.abs));
    return [...row, ...identity4[i]!].map((entry) => entry / (largest || 1));
  });
  for (let c = 0; c < 4; c++) {
    let pivot = c;
    for (let r = c + 1; r < 4; r++) {
      if (Math.abs(rows[r]![c]!) > Math.abs(rows[pivot]![c]!)) pivot = r;
    }
    if (Math.abs(rows[pivot]![c]!) < 1e-12) return null;
    [rows[c], rows[pivot]] = [rows[pivot]!, rows[c]!];
    const divisor = rows[c]![c]!;
    rows[c] = rows[c]!.map((entry) => entry / divisor);
    for (let r = 0; r < 4; r++) {
      const factor = rows[r]![c]!;
      if (r !== c) rows[r] = rows[r]!.map((entry, j) => entry - factor * rows[c]![j]!);
    }
  }
  return rows.map((row) => row.slice(4)) as unknown as Matrix4;
}
