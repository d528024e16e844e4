import { checkNumber, checkNumbers, checkPositive } from "./check.ts";

/**
 * Values on a regular grid in the plane: `values[j][i]` belongs to (x₀ + i·dx, y₀ + j·dy).
 *
 * At least one node; all rows equally long; dx, dy > 0.
 */
export type Grid = {
  readonly origin: readonly [number, number];
  readonly spacing: readonly [number, number];
  readonly values: readonly (readonly number[])[];
};

/** Values on a regular grid in space: `values[k][j][i]` belongs to (x₀ + i·dx, y₀ + j·dy, z₀ + k·dz). */
export type Grid3 = {
  readonly origin: readonly [number, number, number];
  readonly spacing: readonly [number, number, number];
  readonly values: readonly (readonly (readonly number[])[])[];
};

/** Demands a grid as described at `Grid`. @throws RangeError naming the entry that is not as it should be. */
export function checkGrid(grid: Grid): void {
  checkAxes(grid.origin, grid.spacing, 2);
  checkRows("grid.values", grid.values);
}

/** Demands a grid as described at `Grid3`. @throws RangeError naming the entry that is not as it should be. */
export function checkGrid3(grid: Grid3): void {
  checkAxes(grid.origin, grid.spacing, 3);
  if (grid.values.length === 0) throw new RangeError("grid.values: expected at least 1 layer, got none");
  const rows = grid.values[0]!.length;
  const columns = grid.values[0]![0]?.length;
  grid.values.forEach((layer, k) => {
    const name = `grid.values[${k}]`;
    if (layer.length !== rows) {
      throw new RangeError(`${name}: expected ${rows} rows as in layer 0, got ${layer.length}`);
    }
    checkRows(name, layer, columns);
  });
}

/** Where a position lies on one axis of a grid: in the cell from node `i` to node i + 1, at the share `alpha` of it. */
export type AxisCell = {
  readonly i: number;
  readonly alpha: number;
};

/**
 * The cell of an axis with `count` nodes in which x lies. The last node belongs to the last cell (alpha = 1).
 *
 * Positions outside the grid are moved to its nearest border: values there continue as constants. With a single node,
 * i = 0 and alpha = 0.
 */
export function axisCell(origin: number, spacing: number, count: number, x: number): AxisCell {
  const s = Math.min(Math.max((x - origin) / spacing, 0), count - 1);
  const i = Math.max(Math.min(Math.floor(s), count - 2), 0);
  return { i, alpha: s - i };
}

/** The cell of a grid that holds (x, y), with its shares on both axes. */
export function gridCell(grid: Grid, x: number, y: number): { readonly x: AxisCell; readonly y: AxisCell } {
  return {
    x: axisCell(grid.origin[0], grid.spacing[0], grid.values[0]!.length, x),
    y: axisCell(grid.origin[1], grid.spacing[1], grid.values.length, y),
  };
}

/**
 * The grid node nearest to (x, y) as [i, j], i along x; half way between two nodes the lower one on each axis.
 *
 * Positions outside the grid have their nearest node on its border. The grid is taken as it is (see `checkGrid`).
 */
export function nearestNode(grid: Grid, x: number, y: number): [number, number] {
  const cell = gridCell(grid, x, y);
  return [cell.x.i + (cell.x.alpha > 0.5 ? 1 : 0), cell.y.i + (cell.y.alpha > 0.5 ? 1 : 0)];
}

function checkAxes(origin: readonly number[], spacing: readonly number[], dimension: number): void {
  for (let axis = 0; axis < dimension; axis++) {
    checkNumber(`grid.origin[${axis}]`, origin[axis]!);
    checkPositive(`grid.spacing[${axis}]`, spacing[axis]!);
  }
}

function checkRows(name: string, rows: readonly (readonly number[])[], columns = rows[0]?.length): void {
  if (rows.length === 0) throw new RangeError(`${name}: expected at least 1 row, got none`);
  rows.forEach((row, j) => {
    checkNumbers(`${name}[${j}]`, row);
    if (row.length !== columns) {
      throw new RangeError(
        `${name}[${j}]: expected ${columns} values as in the first row, got ${row.length}`,
      );
    }
  });
}
