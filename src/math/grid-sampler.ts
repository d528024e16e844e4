import { bicubicGrid, naturalBicubicSampler } from "./bicubic.ts";
import { bilinearGrid } from "./bilinear.ts";
import { checkGrid, type Grid, nearestNode } from "./grid.ts";

/** The ways to read a grid between its nodes; `catmullRom` and `natural` are bicubic. */
export const gridMethods = ["nearest", "bilinear", "catmullRom", "natural"] as const;
export type GridMethod = (typeof gridMethods)[number];

/**
 * A function (x, y) → value that reads a grid between its nodes by one of the methods.
 *
 * Positions outside the grid are moved to its nearest border. The work that does not depend on the position (the
 * check, the spline's linear systems) is done once.
 *
 * @throws RangeError for a bad grid (see `Grid`) or an unknown method.
 */
export function gridSampler(grid: Grid, method: GridMethod): (x: number, y: number) => number {
  checkGrid(grid);
  switch (method) {
    case "nearest":
      return (x, y) => {
        const [i, j] = nearestNode(grid, x, y);
        return grid.values[j]![i]!;
      };
    case "bilinear":
      return (x, y) => bilinearGrid(grid, x, y);
    case "catmullRom":
      return (x, y) => bicubicGrid(grid, x, y);
    case "natural":
      return naturalBicubicSampler(grid);
    default:
      throw new RangeError(`method: expected one of ${gridMethods.join(", ")}, got "${method as string}"`);
  }
}

/**
 * Fills `out` with columns × rows samples of a function over [x0, x1] × [y0, y1], row by row, y upwards: the batch
 * form for an enlarged picture of a grid. Both ends of both intervals are sampled.
 *
 * @throws RangeError if there are fewer than two columns or rows or `out` is too short.
 */
export function sampleInto(
  out: Float64Array | Float32Array,
  sample: (x: number, y: number) => number,
  columns: number,
  rows: number,
  [x0, x1]: readonly [number, number],
  [y0, y1]: readonly [number, number],
): void {
  if (!(columns >= 2 && rows >= 2)) {
    throw new RangeError(`columns, rows: expected at least 2 each, got ${columns} and ${rows}`);
  }
  if (out.length < columns * rows) {
    throw new RangeError(`out: expected room for ${columns * rows} samples, got ${out.length}`);
  }
  for (let j = 0; j < rows; j++) {
    const y = y0 + ((y1 - y0) * j) / (rows - 1);
    for (let i = 0; i < columns; i++) {
      out[j * columns + i] = sample(x0 + ((x1 - x0) * i) / (columns - 1), y);
    }
  }
}
