import { expect, test } from "vitest";
import { bezierBounds, bezierExtrema, bezierPoint, type Point } from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const arch: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];

test("an arch turns at its top; its box is lower than its control polygon", () => {
  expect(bezierExtrema(arch)).toEqual([[], [0.5]]);
  expect(bezierBounds(arch)).toEqual({ min: [0, 0], max: [5, 2.25] });
  expect(bezierBounds([[5], [1], [1], [5]])).toEqual({ min: [2], max: [5] });
});

test("saddles, constant coordinates and points have no extrema", () => {
  expect(
    bezierExtrema([
      [0, 0],
      [1, 1],
      [0, 2],
      [1, 3],
    ]),
  ).toEqual([[], []]);
  expect(
    bezierExtrema([
      [2, 0],
      [2, 1],
      [2, 5],
    ]),
  ).toEqual([[], []]);
  expect(
    bezierExtrema([
      [0.1 + 0.2, 0],
      [0.3, 1],
      [0.1 + 0.2, 5],
    ]),
  ).toEqual([[], []]);
  expect(bezierExtrema([1000.1, 999.8 + 0.3, 1000.1, 1000.4 - 0.3].map((x) => [x]))).toEqual([[]]);
  expect(
    bezierExtrema([
      [1e-9, 1],
      [-1e-9, 2],
      [1e-9, 3],
    ]),
  ).toEqual([[0.5], []]);
  expect(bezierExtrema([[4, 2]])).toEqual([[], []]);
  expect(bezierBounds([[4, 2]])).toEqual({ min: [4, 2], max: [4, 2] });
});

test("the box holds the curve and every side touches it", () => {
  forAll([points(1, 7), unit], (b, t) => {
    const { min, max } = bezierBounds(b);
    const slack = 1e-10 * size(b);
    bezierPoint(b, t).forEach((x, axis) => {
      expect(x).toBeGreaterThan(min[axis]! - slack);
      expect(x).toBeLessThan(max[axis]! + slack);
    });
    const candidates = [0, 1, ...bezierExtrema(b).flat()].map((u) => bezierPoint(b, u));
    for (const axis of min.keys()) {
      expect(candidates.some((p) => p[axis] === min[axis])).toBe(true);
      expect(candidates.some((p) => p[axis] === max[axis])).toBe(true);
    }
  });
});

test("bad control points are named", () => {
  expect(() => bezierExtrema([])).toThrow("controlPoints: expected at least 1 point, got none");
  expect(() => bezierBounds([])).toThrow("controlPoints: expected at least 1 point, got none");
  expect(() => bezierBounds([[1], [1, 2]])).toThrow(/^controlPoints\[1\]/);
});
