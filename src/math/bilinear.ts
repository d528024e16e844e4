import { checkNumber } from "./check.ts";
import { axisCell, checkGrid3, type Grid, type Grid3, gridCell } from "./grid.ts";
import { mix } from "./linear-interpolation.ts";

/** Bilinear interpolation with its two auxiliary interpolations and the shares of the four corners. */
export type BilinearValue = {
  /** The auxiliary value on the lower edge of the cell. */
  readonly h0: number;
  /** The auxiliary value on the upper edge of the cell. */
  readonly h1: number;
  readonly value: number;
  /** The weights of v00, v10, v01, v11: the areas of the opposite rectangles. They add up to 1. */
  readonly weights: readonly [number, number, number, number];
};

/**
 * Bilinear interpolation in a cell: twice along x, then once along y between the two results.
 *
 * The corners are named v_xy: v10 lies at the far end of the x axis. `alpha` is the share along x, `beta` along y;
 * shares outside [0, 1] continue the patch.
 *
 * @throws RangeError if a number is not finite.
 */
export function bilinearCell(
  v00: number,
  v10: number,
  v01: number,
  v11: number,
  alpha: number,
  beta: number,
): BilinearValue {
  Object.entries({ v00, v10, v01, v11, alpha, beta }).forEach(([name, value]) => {
    checkNumber(name, value);
  });
  const h0 = mix(v00, v10, alpha);
  const h1 = mix(v01, v11, alpha);
  const weights = [(1 - alpha) * (1 - beta), alpha * (1 - beta), (1 - alpha) * beta, alpha * beta] as const;
  return { h0, h1, value: mix(h0, h1, beta), weights };
}

/** The bilinear value of a grid at (x, y); the grid is taken as it is, positions outside go to its border. */
export function bilinearGrid(grid: Grid, x: number, y: number): number {
  const cell = gridCell(grid, x, y);
  const { i, alpha } = cell.x;
  const row = grid.values[cell.y.i]!;
  const next = grid.values[cell.y.i + 1] ?? row;
  const h0 = mix(row[i]!, row[i + 1] ?? row[i]!, alpha);
  const h1 = mix(next[i]!, next[i + 1] ?? next[i]!, alpha);
  return mix(h0, h1, cell.y.alpha);
}

/**
 * A function (x, y, z) → value that interpolates a grid in space trilinearly: bilinearly in the two layers next to z,
 * then linearly between them. Positions outside go to the border of the grid.
 *
 * @throws RangeError for a bad grid (see `Grid3`).
 */
export function trilinearSampler(grid: Grid3): (x: number, y: number, z: number) => number {
  checkGrid3(grid);
  const origin = [grid.origin[0], grid.origin[1]] as const;
  const spacing = [grid.spacing[0], grid.spacing[1]] as const;
  const layers = grid.values.map((values): Grid => ({ origin, spacing, values }));
  return (x, y, z) => {
    const cell = axisCell(grid.origin[2], grid.spacing[2], layers.length, z);
    const layer = layers[cell.i]!;
    return mix(bilinearGrid(layer, x, y), bilinearGrid(layers[cell.i + 1] ?? layer, x, y), cell.alpha);
  };
}
