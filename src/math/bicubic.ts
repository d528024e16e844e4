import { cubicSplineTangents } from "./cubic-spline.ts";
import { axisCell, type Grid, gridCell } from "./grid.ts";
import { hermiteCubicBasis } from "./hermite-segment.ts";

/**
 * The bicubic value of a grid at (x, y) by Catmull-Rom curves: along x through four values of each of four rows, then
 * along y through the four results. It passes through the values, is C¹ and local: 16 nodes act.
 *
 * At the border the missing neighbour continues a parabola, 3·v₀ − 3·v₁ + v₂, so that quadratic data are met
 * everywhere. Overshoot beyond the data is possible. The grid is taken as it is, positions outside go to its border.
 */
export function bicubicGrid(grid: Grid, x: number, y: number): number {
  const cell = gridCell(grid, x, y);
  const value = (row: number) => catmullRomValue(grid.values[row]!, cell.x.i, cell.x.alpha);
  // Only the rows that act are interpolated along x: at most four, in a window of at most four.
  const first = Math.max(Math.min(cell.y.i - 1, grid.values.length - 4), 0);
  const column: number[] = [];
  for (let row = first; row < Math.min(first + 4, grid.values.length); row++) column.push(value(row));
  return catmullRomValue(column, cell.y.i - first, cell.y.alpha);
}

/** The uniform Catmull-Rom curve through `values` at the share u of its i-th piece, ends as parabolas. */
function catmullRomValue(values: readonly number[], i: number, u: number): number {
  const b = values[i]!;
  const c = values[i + 1] ?? b;
  const m0 = slope(values, i);
  const m1 = slope(values, i + 1);
  const [h0, h1, h2, h3] = hermiteCubicBasis(u);
  return h0 * b + h1 * m0 + h2 * m1 + h3 * c;
}

/** Half the difference of the neighbours; at an end the slope of the parabola through the last three values. */
function slope(values: readonly number[], i: number): number {
  const last = values.length - 1;
  if (last < 1) return 0;
  if (last < 2) return values[1]! - values[0]!;
  if (i === 0) return (-3 * values[0]! + 4 * values[1]! - values[2]!) / 2;
  if (i === last) return (3 * values[last]! - 4 * values[last - 1]! + values[last - 2]!) / 2;
  return (values[i + 1]! - values[i - 1]!) / 2;
}

/**
 * A function (x, y) → value that interpolates a grid by natural cubic splines: along x in every row, then along y
 * through the results. It is C² and global: every value acts everywhere, fading by √3 − 2 per node.
 *
 * The slopes along x, along y and of both are solved for once. The grid is taken as it is; positions outside go to its
 * border.
 */
export function naturalBicubicSampler(grid: Grid): (x: number, y: number) => number {
  const f = grid.values;
  const fx = f.map(naturalSlopes);
  const fy = transpose(transpose(f).map(naturalSlopes));
  const fxy = transpose(transpose(fx).map(naturalSlopes));
  return (x, y) => {
    const { i, alpha } = axisCell(grid.origin[0], grid.spacing[0], f[0]!.length, x);
    const { i: j, alpha: beta } = axisCell(grid.origin[1], grid.spacing[1], f.length, y);
    const along = hermiteCubicBasis(alpha);
    const row = (values: Rows, slopes: Rows, k: number) =>
      segment(values[k] ?? [], slopes[k] ?? [], i, along);
    const [h0, h1, h2, h3] = hermiteCubicBasis(beta);
    return h0 * row(f, fx, j) + h1 * row(fy, fxy, j) + h2 * row(fy, fxy, j + 1) + h3 * row(f, fx, j + 1);
  };
}

type Rows = readonly (readonly number[])[];

/** The cubic Hermite segment between the i-th value and the next; what lies beyond the grid has weight 0. */
function segment(
  values: readonly number[],
  slopes: readonly number[],
  i: number,
  [h0, h1, h2, h3]: readonly [number, number, number, number],
): number {
  return (
    h0 * (values[i] ?? 0) + h1 * (slopes[i] ?? 0) + h2 * (slopes[i + 1] ?? 0) + h3 * (values[i + 1] ?? 0)
  );
}

/** The slopes of the natural cubic spline through values at 0, 1, 2, …; a single value is a constant. */
function naturalSlopes(values: readonly number[]): number[] {
  if (values.length < 2) return values.map(() => 0);
  const nodes = values.map((_, i) => i);
  return cubicSplineTangents(
    nodes,
    values.map((value) => [value]),
    { type: "natural" },
  ).map(([m]) => m!);
}

function transpose(rows: Rows): number[][] {
  return rows[0]!.map((_, i) => rows.map((row) => row[i]!));
}
