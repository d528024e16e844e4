import fc from "fast-check";
import { expect, test } from "vitest";
import { distance, nearestIndex, nearestIndex1d } from "../../src/math/index.ts";
import { coordinate, forAll, point, points } from "./property.ts";

test("no other data point is nearer, and of equally near ones the first is taken", () => {
  forAll([points(1, 12, 2), point(2)], (data, query) => {
    const found = nearestIndex(data, query);
    const least = distance(data[found]!, query);
    data.forEach((p, i) => {
      expect(distance(p, query)).toBeGreaterThanOrEqual(least);
      if (i < found) expect(distance(p, query)).toBeGreaterThan(least);
    });
  });
});

test("on a line it agrees with points of dimension 1", () => {
  forAll([fc.array(coordinate, { minLength: 1, maxLength: 12 }), coordinate], (positions, x) => {
    const data = positions.map((position) => [position]);
    expect(nearestIndex1d(positions, x)).toBe(nearestIndex(data, [x]));
  });
});

test("ties go to the lowest index, whatever the order of the data", () => {
  expect(nearestIndex1d([4, 0, 2], 3)).toBe(0);
  expect(nearestIndex1d([2, 0, 4], 3)).toBe(0);
  expect(nearestIndex1d([7, 7], 7)).toBe(0);
});

test("bad arguments are named", () => {
  expect(() => nearestIndex1d([], 0)).toThrow("positions: expected at least 1 number, got none");
  expect(() => nearestIndex1d([0, Number.NaN], 0)).toThrow("positions[1]: expected a finite number, got NaN");
  expect(() => nearestIndex1d([0], Number.POSITIVE_INFINITY)).toThrow(
    "x: expected a finite number, got Infinity",
  );
  expect(() => nearestIndex([], [0])).toThrow("points: expected at least 1 point, got none");
  expect(() => nearestIndex([[0, 0]], [0])).toThrow("query: expected 2 coordinates, got [0]");
});
