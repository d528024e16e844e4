import fc from "fast-check";
import { expect, test } from "vitest";
import {
  bezierPoint,
  distance,
  norm,
  type Point,
  rationalBezierDerivative,
  rationalBezierPoint,
  scale,
  splitRationalBezier,
  sub,
} from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

const quarter: Point[] = [
  [1, 0],
  [1, 1],
  [0, 1],
];
const weights = [1, Math.SQRT1_2, 1];
const weight = fc.double({ min: 0.1, max: 10, noNaN: true });
const curve = fc
  .integer({ min: 1, max: 6 })
  .chain((n) =>
    fc.tuple(
      fc.array(point(2), { minLength: n, maxLength: n }),
      fc.array(weight, { minLength: n, maxLength: n }),
    ),
  );

test("a quarter of the circle, exactly", () => {
  forAll([unit], (t) => {
    const p = rationalBezierPoint(quarter, weights, t)!;
    expect(Math.abs(norm(p) - 1)).toBeLessThan(1e-15 * 4);
    const tangent = rationalBezierDerivative(quarter, weights, t)!;
    expect(Math.abs(p[0]! * tangent[0]! + p[1]! * tangent[1]!)).toBeLessThan(1e-14);
  });
});

test("equal weights give the polynomial curve; a common factor changes nothing", () => {
  forAll([curve, unit, weight], ([b, w], t, factor) => {
    const equal = rationalBezierPoint(
      b,
      b.map(() => factor),
      t,
    )!;
    expect(distance(equal, bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
    const p = rationalBezierPoint(b, w, t)!;
    const scaled = rationalBezierPoint(
      b,
      w.map((x) => -factor * x),
      t,
    )!;
    expect(distance(p, scaled)).toBeLessThan(1e-12 * size(b));
  });
});

test("derivatives agree with difference quotients", () => {
  const h = 1e-5;
  const inside = fc.double({ min: 0.01, max: 0.99, noNaN: true });
  forAll([curve, inside, fc.integer({ min: 0, max: 1 })], ([b, w], t, r) => {
    const ahead = rationalBezierDerivative(b, w, t + h, r)!;
    const behind = rationalBezierDerivative(b, w, t - h, r)!;
    const quotient = scale(sub(ahead, behind), 1 / (2 * h));
    const exact = rationalBezierDerivative(b, w, t, r + 1)!;
    const third = rationalBezierDerivative(b, w, t, r + 3)!;
    const bound = 1e-4 * size(b) + 1e-4 * norm(exact) + 1e-8 * norm(third);
    expect(distance(exact, quotient)).toBeLessThan(bound);
  });
});

test("a pole is null, whatever the order", () => {
  const line: Point[] = [
    [0, 0],
    [1, 1],
  ];
  expect(rationalBezierPoint(line, [1, -1], 0.5)).toBeNull();
  expect(rationalBezierDerivative(line, [1, -1], 0.5, 2)).toBeNull();
  expect(rationalBezierPoint(line, [1, -1], 0.25)).toEqual([-0.5, -0.5]);
  expect(rationalBezierPoint(line, [0, 1], 0)).toBeNull();
  expect(rationalBezierPoint(line, [1e-30, -1e-30], 0.25)).toEqual([-0.5, -0.5]);
});

test("close to a pole means: beside the largest weight", () => {
  const line: Point[] = [[0], [1]];
  const pole = 1e6 / 1000001;
  expect(rationalBezierPoint(line, [1e6, -1], pole + 1e-11)).toBeNull();
  expect(rationalBezierPoint(line, [1e6, -1], pole + 1e-9)).not.toBeNull();
});

test("a split is the same curve in two pieces", () => {
  forAll([curve, unit, unit], ([b, w], t, u) => {
    const [left, right] = splitRationalBezier(b, w, t)!;
    const onLeft = rationalBezierPoint(left.controlPoints, left.weights, u)!;
    const onRight = rationalBezierPoint(right.controlPoints, right.weights, u)!;
    expect(distance(onLeft, rationalBezierPoint(b, w, t * u)!)).toBeLessThan(1e-10 * size(b));
    expect(distance(onRight, rationalBezierPoint(b, w, t + (1 - t) * u)!)).toBeLessThan(1e-10 * size(b));
  });
  expect(splitRationalBezier([[0], [1]], [1, -1], 0.5)).toBeNull();
  expect(splitRationalBezier([[0], [1]], [0, 1], 0.5)).toBeNull();
  expect(splitRationalBezier([[0], [1]], [1, 0], 0.5)).toBeNull();
});

test("bad arguments are named", () => {
  expect(() => rationalBezierPoint(quarter, [1, 1], 0)).toThrow(/^weights: expected 3 weights/);
  expect(() => rationalBezierPoint(quarter, [0, 0, 0], 0)).toThrow(/^weights: expected at least one/);
  expect(() => rationalBezierDerivative(quarter, weights, 0, -1)).toThrow(/^r: /);
  expect(() => rationalBezierPoint(quarter, weights, Number.NaN)).toThrow(/^t: /);
  expect(() => splitRationalBezier([], [], 0)).toThrow(RangeError);
});
