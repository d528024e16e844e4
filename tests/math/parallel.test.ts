import fc from "fast-check";
import { expect, test } from "vitest";
import { norm, parallelFactor, scale } from "../../src/math/index.ts";
import { forAll, point } from "./property.ts";

test("the factor of parallel vectors, negative for opposite ones", () => {
  expect(parallelFactor([2, 4], [1, 2])).toBe(2);
  expect(parallelFactor([-2, -4, 0], [1, 2, 0])).toBe(-2);
  forAll([point(3), fc.double({ min: -9, max: 9, noNaN: true })], (direction, factor) => {
    fc.pre(norm(direction) > 1e-3 && Math.abs(factor) > 1e-3);
    expect(parallelFactor(scale(direction, factor), direction)).toBeCloseTo(factor, 9);
  });
});

test("null for other directions and without one; the tolerance is an angle", () => {
  expect(parallelFactor([1, 0], [1, 1])).toBeNull();
  expect(parallelFactor([0, 0], [1, 1])).toBeNull();
  expect(parallelFactor([1, 1], [0, 0])).toBeNull();
  expect(parallelFactor([1, 1e-7], [1, 0])).toBe(1);
  expect(parallelFactor([1, 1e-5], [1, 0])).toBeNull();
  expect(parallelFactor([-1, 1e-5], [1, 0])).toBeNull();
  expect(parallelFactor([-1, 0.1], [1, 0], 0.2)).toBe(-1);
});

test("bad vectors are named", () => {
  expect(() => parallelFactor([Number.NaN], [1])).toThrow(/^vector\[0\]/);
  expect(() => parallelFactor([1, 2], [1])).toThrow("direction: expected 2 coordinates, got [1]");
});
