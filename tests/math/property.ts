import fc from "fast-check";
import { vi } from "vitest";
import type { Point } from "../../src/math/index.ts";

// A thousand runs on a busy machine take longer than a unit test may.
vi.setConfig({ testTimeout: 120_000 });

/** Runs of each property; a mutation run sets PROPERTY_RUNS=25. */
const numRuns = Number(process.env.PROPERTY_RUNS ?? 1000);

/** The same cases in every run, so that a failure can be repeated; PROPERTY_SEED tries others. */
const seed = Number(process.env.PROPERTY_SEED ?? 20240229);

/** Checks that a predicate holds (returns, or does not throw) for all generated values; a failure is shrunk. */
export function forAll<Values extends [unknown, ...unknown[]]>(
  ...[arbitraries, predicate]: [
    arbitraries: { [K in keyof Values]: fc.Arbitrary<Values[K]> },
    predicate: (...values: Values) => void,
  ]
): void {
  fc.assert(fc.property(...arbitraries, predicate), { numRuns, seed });
}

/** A coordinate of moderate size, often 0 or another small whole number. */
export const coordinate: fc.Arbitrary<number> = fc.oneof(
  fc.integer({ min: -5, max: 5 }),
  fc.double({ min: -100, max: 100, noNaN: true }).map((x) => (Math.abs(x) < 1e-9 ? 0 : x)),
);

/** A parameter in [0, 1], often one of the ends. */
export const unit: fc.Arbitrary<number> = fc.oneof(
  fc.constantFrom(0, 1, 0.5),
  fc.double({ min: 0, max: 1, noNaN: true }),
);

/** A point of a dimension. */
export function point(dimension: number): fc.Arbitrary<Point> {
  return fc.array(coordinate, { minLength: dimension, maxLength: dimension });
}

/** A list of points of one dimension, by default of 1 … 4 dimensions. */
export function points(minimum: number, maximum: number, dimension?: number): fc.Arbitrary<Point[]> {
  const dimensions = dimension === undefined ? fc.integer({ min: 1, max: 4 }) : fc.constant(dimension);
  return dimensions.chain((d) => fc.array(point(d), { minLength: minimum, maxLength: maximum }));
}

/** The largest coordinate, at least 1: what a rounding error is measured against. */
export function size(list: readonly Point[]): number {
  return Math.max(1, ...list.flat().map(Math.abs));
}
