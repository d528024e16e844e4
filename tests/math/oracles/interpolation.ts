import {
  bilinearCell,
  type Grid,
  type Grid3,
  gridSampler,
  linearFromDistances,
  linearPosition,
  linearValue,
  nearestIndex,
  nearestIndex1d,
  nearestNode,
  type Point,
  piecewiseLinearPositions,
  piecewiseLinearValue,
  trilinearSampler,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Pair = { p1: number; v1: number; p2: number; v2: number };

export const adapter: Adapter = {
  nearest1d: ({
    positions,
    values,
    queries,
  }: {
    positions: number[];
    values: number[];
    queries: number[];
  }) => {
    const indices = queries.map((x) => nearestIndex1d(positions, x));
    return { indices, values: indices.map((i) => values[i]) };
  },
  nearest2d: ({ points, values, queries }: { points: Point[]; values: number[]; queries: Point[] }) => {
    const indices = queries.map((query) => nearestIndex(points, query));
    return { indices, values: indices.map((i) => values[i]) };
  },
  nearestGrid: ({ grid, queries }: { grid: Grid; queries: [number, number][] }) => {
    const sample = gridSampler(grid, "nearest");
    return {
      nodes: queries.map(([x, y]) => nearestNode(grid, x, y)),
      values: queries.map(([x, y]) => sample(x, y)),
    };
  },
  linearFromDistances: ({ v1, v2, d1, d2 }: { v1: number; v2: number; d1: number; d2: number }) =>
    linearFromDistances(v1, v2, d1, d2),
  linearValue: ({ p1, v1, p2, v2, queries }: Pair & { queries: number[] }) => {
    const found = queries.map((position) => linearValue(p1, v1, p2, v2, position));
    return undefinedIfAll(found, (f) => ({
      alpha: f.map((x) => x.alpha),
      values: f.map((x) => x.value),
    }));
  },
  linearPosition: (input: { p1: Value; v1: number; p2: Value; v2: number; values: number[] }) => {
    const { p1, v1, p2, v2, values } = input;
    const found = values.map((value) => linearPosition(toPoint(p1), v1, toPoint(p2), v2, value));
    return undefinedIfAll(found, (f) => ({
      alpha: f.map((x) => x.alpha),
      positions: f.map((x) => toValue(x.position, p1)),
    }));
  },
  piecewiseLinearValue: (input: { positions: number[]; values: number[]; queries: number[] }) => ({
    values: input.queries.map((x) => piecewiseLinearValue(input.positions, input.values, x)),
  }),
  piecewiseLinearPosition: (input: { positions: number[]; values: number[]; target: number }) => {
    const { positions, plateaus } = piecewiseLinearPositions(input.positions, input.values, input.target);
    return plateaus.length > 0 ? null : { positions };
  },
  bilinearCell: (input: {
    v00: number;
    v10: number;
    v01: number;
    v11: number;
    alpha: number;
    beta: number;
  }) => bilinearCell(input.v00, input.v10, input.v01, input.v11, input.alpha, input.beta),
  bilinearGrid: ({ grid, queries }: { grid: Grid; queries: [number, number][] }) => {
    const sample = gridSampler(grid, "bilinear");
    return { values: queries.map(([x, y]) => sample(x, y)) };
  },
  trilinearGrid: ({ grid, queries }: { grid: Grid3; queries: [number, number, number][] }) => {
    const sample = trilinearSampler(grid);
    return { values: queries.map(([x, y, z]) => sample(x, y, z)) };
  },
};

/** The whole problem is undefined if no query has an answer; a mixture would be an error of the module. */
function undefinedIfAll<T, R>(found: readonly (T | null)[], result: (all: T[]) => R): R | null {
  const defined = found.filter((x) => x !== null);
  if (defined.length === 0) return null;
  if (defined.length < found.length) throw new Error("some queries have an answer and some have not");
  return result(defined);
}
