import { describe, expect, test } from "vitest";
import {
  add,
  angleBetween,
  combine,
  cross,
  cross2,
  distance,
  dot,
  lerp,
  norm,
  normalize,
  type Point,
  parallelogramArea,
  scale,
  sub,
  zero,
} from "../../src/math/index.ts";
import { forAll, point } from "./property.ts";

test("sum, difference, multiple, scalar product", () => {
  expect(add([1, 2, 3], [10, 20, 30])).toEqual([11, 22, 33]);
  expect(sub([1, 2], [10, 30])).toEqual([-9, -28]);
  expect(scale([1, -2], 3)).toEqual([3, -6]);
  expect(dot([1, 2, 3], [4, 5, 6])).toBe(32);
  expect(zero(3)).toEqual([0, 0, 0]);
  expect(
    combine(
      [2, 3, -1],
      [
        [1, 0],
        [0, 1],
        [5, 7],
      ],
    ),
  ).toEqual([-3, -4]);
});

test("lerp gives its ends exactly and continues the line", () => {
  expect(lerp([1, 5], [3, 9], 0.25)).toEqual([1.5, 6]);
  expect(lerp([1, 5], [3, 9], 2)).toEqual([5, 13]);
  forAll([point(3), point(3)], (a, b) => {
    expect(lerp(a, b, 0).map((x) => x + 0)).toEqual(a.map((x) => x + 0));
    expect(lerp(a, b, 1).map((x) => x + 0)).toEqual(b.map((x) => x + 0));
  });
  expect(lerp([-1.7e308], [1.7e308], 0.5)).toEqual([0]);
});

describe("norm", () => {
  test("is the Euclidean length", () => {
    expect(norm([3, -4])).toBe(5);
    expect(norm([2, 3, 6])).toBe(7);
    expect(norm([])).toBe(0);
    expect(distance([1, 1], [4, 5])).toBe(5);
  });
  test("neither overflows nor underflows", () => {
    expect(norm([3e200, 4e200])).toBeCloseTo(5e200, -190);
    expect(norm([3e-200, 4e-200]) / 5e-200).toBeCloseTo(1, 14);
  });
});

describe("normalize", () => {
  test("has length 1 and keeps the direction, for tiny and huge vectors too", () => {
    expect(normalize([0, -2])).toEqual([0, -1]);
    for (const factor of [1e-320, 1e-300, 1, 1e300]) {
      const [x, y] = normalize([3 * factor, 4 * factor]) as [number, number];
      expect(x).toBeCloseTo(0.6, 3);
      expect(y).toBeCloseTo(0.8, 3);
    }
  });
  test("of the zero vector is null", () => {
    expect(normalize([0, 0, -0])).toBeNull();
    expect(normalize([])).toBeNull();
  });
});

test("vector product, determinant, area", () => {
  expect(cross([1, 2, 3], [4, 5, 6])).toEqual([-3, 6, -3]);
  expect(cross2([1, 0], [0, 1])).toBe(1);
  expect(cross2([2, 3], [5, 7])).toBe(-1);
  expect(parallelogramArea([2, 3], [5, 7])).toBe(1);
  expect(parallelogramArea([5], [7])).toBe(0);
  expect(parallelogramArea([1, 2, 3, 0], [4, 5, 6, 0])).toBeCloseTo(Math.sqrt(54), 12);
  forAll([point(3), point(3)], (a, b) => {
    const product = cross(a, b);
    const bound = 1e-13 * (1 + norm(a) * norm(b)) * (1 + norm(a) + norm(b));
    expect(Math.abs(dot(product, a))).toBeLessThanOrEqual(bound);
    expect(Math.abs(dot(product, b))).toBeLessThanOrEqual(bound);
    expect(Math.abs(norm(product) - parallelogramArea(a, b))).toBeLessThanOrEqual(bound);
  });
});

test("angles: 0 … π, null without a direction, accurate for nearly parallel vectors", () => {
  expect(angleBetween([1, 0], [0, 5])).toBeCloseTo(Math.PI / 2, 15);
  expect(angleBetween([1, 0], [-2, 0])).toBeCloseTo(Math.PI, 15);
  expect(angleBetween([1, 1, 0], [2, 2, 0])).toBeCloseTo(0, 15);
  expect(angleBetween([1, 0], [1, 1e-9])! / 1e-9).toBeCloseTo(1, 9);
  expect(angleBetween([0, 0], [1, 1])).toBeNull();
  expect(angleBetween([1, 1], [0, 0])).toBeNull();
});

test("new points are made; arguments stay as they were", () => {
  const a: Point = Object.freeze([1, 2]);
  const b: Point = Object.freeze([3, 4]);
  for (const result of [add(a, b), sub(a, b), scale(a, 2), lerp(a, b, 0.5)]) expect(result).not.toBe(a);
});
