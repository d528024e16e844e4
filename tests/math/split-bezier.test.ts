import { expect, test } from "vitest";
import { bezierPoint, bezierSegment, distance, lerp, type Point, splitBezier } from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const cubic: Point[] = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];

test("the two sides of de Casteljau's triangle, both in the direction of the curve", () => {
  expect(splitBezier(cubic, 0.5)).toEqual([
    [
      [0, 0],
      [0.5, 1],
      [1.25, 1.5],
      [2, 1.5],
    ],
    [
      [2, 1.5],
      [2.75, 1.5],
      [3.5, 1],
      [4, 0],
    ],
  ]);
});

test("the pieces are the original curve", () => {
  forAll([points(1, 8), unit, unit], (b, t, u) => {
    const [left, right] = splitBezier(b, t);
    expect(left.at(-1)).toEqual(right[0]);
    expect(distance(bezierPoint(left, u), bezierPoint(b, u * t))).toBeLessThan(1e-12 * size(b));
    expect(distance(bezierPoint(right, u), bezierPoint(b, t + u * (1 - t)))).toBeLessThan(1e-12 * size(b));
  });
});

test("a split at an end leaves the whole and a point", () => {
  const [start, all] = splitBezier(cubic, 0);
  expect(start).toEqual([
    [0, 0],
    [0, 0],
    [0, 0],
    [0, 0],
  ]);
  expect(all).toEqual(cubic);
});

test("a segment runs from its first to its second parameter", () => {
  forAll([points(1, 7), unit, unit, unit], (b, t0, t1, u) => {
    const segment = bezierSegment(b, t0, t1);
    expect(segment).toHaveLength(b.length);
    const expected = bezierPoint(b, lerp([t0], [t1], u)[0]!);
    expect(distance(bezierPoint(segment, u), expected)).toBeLessThan(1e-11 * size(b));
  });
  expect(bezierSegment(cubic, 1, 0)).toEqual([...cubic].reverse());
  expect(bezierSegment(cubic, 0.5, 0.5)).toEqual(new Array(4).fill([2, 1.5]));
});

test("bad data are named", () => {
  expect(() => splitBezier([], 0.5)).toThrow("controlPoints: expected at least 1 point, got none");
  expect(() => splitBezier(cubic, Number.NaN)).toThrow(/^t: /);
  expect(() => bezierSegment([], 0, 1)).toThrow(/^controlPoints: /);
  expect(() => bezierSegment(cubic, 0, Number.NaN)).toThrow(/^ts\[2\]: /);
});
