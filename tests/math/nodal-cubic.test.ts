import fc from "fast-check";
import { expect, test } from "vitest";
import {
  distance,
  dot,
  nodalCubicBranch,
  nodalCubicGradient,
  nodalCubicOrdinates,
  nodalCubicParameters,
  nodalCubicPoint,
  nodalCubicTangent,
  nodalCubicValue,
  type Point,
  scale,
  sub,
} from "../../src/math/index.ts";
import { forAll } from "./property.ts";

const parameter = fc.double({ min: -3, max: 3, noNaN: true });

test("the parametric point lies on the implicit curve, its tangent along it", () => {
  forAll([parameter], (t) => {
    const p = nodalCubicPoint(t);
    expect(Math.abs(nodalCubicValue(p))).toBeLessThan(1e-12);
    expect(Math.abs(dot(nodalCubicGradient(p), nodalCubicTangent(t)))).toBeLessThan(1e-11);
    const quotient = scale(sub(nodalCubicPoint(t + 1e-6), nodalCubicPoint(t - 1e-6)), 5e5);
    expect(distance(quotient, nodalCubicTangent(t))).toBeLessThan(1e-8);
    expect(nodalCubicOrdinates(p[0]!).some((y) => Math.abs(y - p[1]!) < 1e-12)).toBe(true);
    const found = nodalCubicParameters(p);
    expect(found.some((s) => Math.abs(s - t) < 1e-8)).toBe(true);
  });
});

test("the gradient is the derivative of the value", () => {
  forAll([parameter, parameter], (x, y) => {
    const h = 1e-5;
    const quotient = [
      (nodalCubicValue([x + h, y]) - nodalCubicValue([x - h, y])) / (2 * h),
      (nodalCubicValue([x, y + h]) - nodalCubicValue([x, y - h])) / (2 * h),
    ];
    expect(distance(quotient, nodalCubicGradient([x, y]))).toBeLessThan(1e-7);
  });
});

test("the explicit form is the branch t ≥ 0 only", () => {
  expect([0, 0.25, 1, 4].map(nodalCubicBranch)).toEqual([-0, -0.375, 0, 6]);
  expect(nodalCubicBranch(-1e-9)).toBeNull();
});

test("ordinates and parameters: two, one or none", () => {
  expect(nodalCubicOrdinates(4)).toEqual([-6, 6]);
  expect(nodalCubicOrdinates(0.25)).toEqual([-0.375, 0.375]);
  expect([0, 1].map(nodalCubicOrdinates)).toEqual([[0], [0]]);
  expect(nodalCubicOrdinates(-1)).toEqual([]);
  const parameters = (p: Point) => nodalCubicParameters(p);
  expect(parameters([1, 0])).toEqual([-1, 1]);
  expect(parameters([0, 0])).toEqual([0]);
  expect(parameters([4, -6])).toEqual([-2]);
  expect(parameters([4, -6.001])).toEqual([]);
  expect(parameters([-1e-12, 0])).toEqual([0]);
  expect(parameters([-1, 0])).toEqual([]);
  expect(nodalCubicParameters([4, -6.001], 1e-3)).toEqual([-2]);
});

test("bad arguments are named", () => {
  for (const f of [nodalCubicPoint, nodalCubicTangent]) expect(() => f(Number.NaN)).toThrow(/^t: /);
  for (const f of [nodalCubicBranch, nodalCubicOrdinates]) expect(() => f(Infinity)).toThrow(/^x: /);
  for (const f of [nodalCubicValue, nodalCubicGradient, nodalCubicParameters]) {
    expect(() => f([1])).toThrow("point: expected 2 coordinates, got [1]");
  }
});
