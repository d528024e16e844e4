import fc from "fast-check";
import { expect, test } from "vitest";
import { bezierPoint, distance, elevateDegree, type Point, reduceDegree } from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const cubic: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];

test("reduction undoes elevation", () => {
  forAll([points(2, 6), fc.integer({ min: 0, max: 3 })], (b, times) => {
    const { controlPoints, error } = reduceDegree(elevateDegree(b, times), times);
    expect(controlPoints).toHaveLength(b.length);
    expect(error).toBeLessThan(1e-10 * size(b));
    controlPoints.forEach((p, i) => {
      expect(distance(p, b[i]!)).toBeLessThan(1e-10 * size(b));
    });
  });
});

test("reduction keeps the ends and stays within the error it states", () => {
  forAll([points(3, 7), unit], (b, t) => {
    const { controlPoints, error } = reduceDegree(b);
    expect(controlPoints).toHaveLength(b.length - 1);
    expect(distance(controlPoints[0]!, b[0]!)).toBe(0);
    expect(distance(controlPoints.at(-1)!, b.at(-1)!)).toBe(0);
    expect(distance(bezierPoint(controlPoints, t), bezierPoint(b, t))).toBeLessThanOrEqual(
      error + 1e-11 * size(b),
    );
  });
});

test("reduction by hand: the middle point of an odd degree is the mean of both ways", () => {
  const { controlPoints, error } = reduceDegree([[0], [3], [3], [0]]);
  expect(controlPoints).toEqual([[0], [4.5], [0]]);
  expect(error).toBeCloseTo(0, 14);
  expect(reduceDegree([[0], [3], [0], [0]])).toEqual({ controlPoints: [[0], [2.25], [0]], error: 1.5 });
  expect(reduceDegree([[0], [2], [6]])).toEqual({ controlPoints: [[0], [6]], error: 1 });
  expect(reduceDegree([[0], [4], [9], [4], [0]]).controlPoints).toEqual([[0], [16 / 3], [16 / 3], [0]]);
  expect(reduceDegree(cubic, 0)).toEqual({ controlPoints: cubic, error: 0 });
  expect(reduceDegree(cubic, 2).controlPoints).toEqual([
    [0, 0],
    [5, 0],
  ]);
});

test("bad arguments are named", () => {
  expect(() => reduceDegree(cubic, 3)).toThrow("times: expected a whole number from 0 to 2, got 3");
  expect(() => reduceDegree([[1]], 1)).toThrow("times: expected a whole number from 0 to 0, got 1");
  expect(() => reduceDegree([])).toThrow(/^controlPoints: /);
});
