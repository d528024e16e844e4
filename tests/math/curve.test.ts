import fc from "fast-check";
import { expect, test } from "vitest";
import {
  bezierCurve,
  bezierDerivative,
  distance,
  norm,
  type Point,
  rationalBezierCurve,
  rationalBezierPoint,
  scale,
} from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const cubic: Point[] = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];

test("a Bézier curve over [0, 1] is the curve of its control points", () => {
  const curve = bezierCurve(cubic);
  expect(curve.dimension).toBe(2);
  expect(curve.domain).toEqual([0, 1]);
  expect(curve.point(0.5)).toEqual([2, 1.5]);
  expect(curve.derivative(0)).toEqual([3, 6]);
  expect(curve.derivative(0.5, 0)).toEqual([2, 1.5]);
  expect(curve.derivative(0, 3)).toEqual(bezierDerivative(cubic, 0, 3));
  expect(curve.derivative(0, 40)).toEqual([0, 0]);
  expect(bezierCurve([[7]]).derivative(0)).toEqual([0]);
});

test("over another domain, derivatives refer to its parameter", () => {
  const curve = bezierCurve(cubic, [2, 6]);
  expect(curve.point(2)).toEqual([0, 0]);
  expect(curve.point(4)).toEqual([2, 1.5]);
  expect(curve.derivative(2)).toEqual([0.75, 1.5]);
  expect(curve.derivative(2, 2)).toEqual(scale(bezierDerivative(cubic, 0, 2), 1 / 16));
});

test("its speed bounds the first derivative", () => {
  forAll([points(1, 6), unit], (b, t) => {
    const curve = bezierCurve(b, [-1, 2]);
    expect(norm(curve.derivative(-1 + 3 * t))).toBeLessThanOrEqual(curve.speed! * (1 + 1e-12));
  });
  expect(
    bezierCurve(
      [
        [0, 0],
        [3, 4],
      ],
      [0, 2],
    ).speed,
  ).toBe(2.5);
});

test("a split keeps the parameter of the whole", () => {
  const inside = fc.double({ min: 0.1, max: 0.9, noNaN: true });
  forAll([points(1, 6), inside, unit], (b, t, u) => {
    const curve = bezierCurve(b, [1, 3]);
    const [left, right] = curve.split!(1 + 2 * t);
    expect(left.domain).toEqual([1, 1 + 2 * t]);
    expect(right.domain).toEqual([1 + 2 * t, 3]);
    for (const piece of [left, right]) {
      const [a, z] = piece.domain;
      const s = a + u * (z - a);
      expect(distance(piece.point(s), curve.point(s))).toBeLessThan(1e-11 * size(b));
      expect(distance(piece.derivative(s), curve.derivative(s))).toBeLessThan(1e-9 * size(b));
    }
  });
});

test("a rational curve with positive weights", () => {
  const curve = rationalBezierCurve(cubic, [1, 2, 3, 1]);
  expect([curve.dimension, curve.domain]).toEqual([2, [0, 1]]);
  expect(curve.point(0.3)).toEqual(rationalBezierPoint(cubic, [1, 2, 3, 1], 0.3));
  expect(curve.derivative(0)).toEqual([6, 12]);
  expect(curve.derivative(0.3, 0)).toEqual(curve.point(0.3));
  const even = rationalBezierCurve(cubic, [1, 1, 1, 1]);
  expect(distance(even.derivative(0.3, 2), bezierDerivative(cubic, 0.3, 2))).toBeLessThan(1e-12);
});

test("bad data are named", () => {
  expect(() => bezierCurve([])).toThrow("controlPoints: expected at least 1 point, got none");
  expect(() => bezierCurve(cubic, [1, 1])).toThrow(
    "domain[1]: expected a number greater than domain[0] = 1, got 1",
  );
  expect(() => bezierCurve(cubic).derivative(0, -1)).toThrow(/^r: /);
  expect(() => rationalBezierCurve(cubic, [1, 0, 1, 1])).toThrow(
    "weights[1]: expected a positive finite number, got 0",
  );
  expect(() => rationalBezierCurve(cubic, [1, 1])).toThrow(/^weights: expected 4 weights/);
  expect(() => rationalBezierCurve([], [])).toThrow(/^controlPoints: /);
});
