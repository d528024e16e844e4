import fc from "fast-check";
import { expect, test } from "vitest";
import { bezierPoint, distance, elevateDegree, type Point } from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const cubic: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];

test("one step cuts corners at i/(n + 1)", () => {
  expect(elevateDegree(cubic)).toEqual([
    [0, 0],
    [0.75, 2.25],
    [2.5, 3],
    [4.25, 2.25],
    [5, 0],
  ]);
  expect(elevateDegree([[2, 5]])).toEqual([
    [2, 5],
    [2, 5],
  ]);
  expect(elevateDegree(cubic, 0)).toEqual(cubic);
});

test("elevation keeps the curve and its ends", () => {
  forAll([points(1, 7), fc.integer({ min: 0, max: 5 }), unit], (b, times, t) => {
    const elevated = elevateDegree(b, times);
    expect(elevated).toHaveLength(b.length + times);
    expect(elevated[0]).toEqual(b[0]);
    expect(elevated.at(-1)).toEqual(b.at(-1));
    expect(distance(bezierPoint(elevated, t), bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
  });
});

test("bad arguments are named", () => {
  expect(() => elevateDegree([])).toThrow("controlPoints: expected at least 1 point, got none");
  expect(() => elevateDegree(cubic, -1)).toThrow("times: expected a whole number of at least 0, got -1");
});
