import fc from "fast-check";
import { expect, test } from "vitest";
import {
  arclength,
  bezierCurve,
  type Curve,
  norm,
  parameterAtLength,
  rationalBezierCurve,
} from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const quarter = rationalBezierCurve(
  [
    [2, 0],
    [2, 2],
    [0, 2],
  ],
  [1, Math.SQRT1_2, 1],
);

test("a line, a quarter of the circle of radius 2, a cusp, a point", () => {
  expect(
    arclength(
      bezierCurve([
        [0, 0],
        [3, 4],
      ]),
      1e-12,
    ),
  ).toBeCloseTo(5, 12);
  expect(arclength(quarter, 1e-12)).toBeCloseTo(Math.PI, 12);
  expect(
    arclength(
      bezierCurve([
        [0, 0],
        [2, 2],
        [0, 2],
        [2, 0],
      ]),
      1e-10,
    ),
  ).toBeCloseTo(3.65685424949238, 9);
  expect(arclength(bezierCurve([[1, 1]]), 1e-12)).toBe(0);
  // One dimension: there and back.
  expect(arclength(bezierCurve([[0], [2], [0]]), 1e-12)).toBeCloseTo(2, 12);
});

test("between two parameters, negative backwards, beyond the domain", () => {
  const line = bezierCurve(
    [
      [0, 0],
      [3, 4],
    ],
    [0, 2],
  );
  expect(arclength(line, 1e-9, 0.5, 1)).toBeCloseTo(1.25, 12);
  expect(arclength(line, 1e-9, 1, 0.5)).toBeCloseTo(-1.25, 12);
  expect(arclength(line, 1e-9, 1)).toBeCloseTo(2.5, 12);
  expect(arclength(line, 1e-9, 0, 4)).toBeCloseTo(10, 12);
  expect(arclength(line, 1e-9, 1, 1)).toBe(0);
});

test("is additive, not shorter than the chord, not longer than the control polygon", () => {
  forAll([points(2, 6), unit], (b, t) => {
    const curve = bezierCurve(b);
    const accuracy = 1e-9 * size(b);
    const whole = arclength(curve, accuracy);
    const parts = arclength(curve, accuracy, 0, t) + arclength(curve, accuracy, t, 1);
    expect(Math.abs(whole - parts)).toBeLessThan(3 * accuracy);
    const legs = b.slice(1).reduce((sum, p, i) => sum + norm(p.map((x, axis) => x - b[i]![axis]!)), 0);
    const chord = norm(b.at(-1)!.map((x, axis) => x - b[0]![axis]!));
    expect(whole).toBeGreaterThan(chord - 2 * accuracy);
    expect(whole).toBeLessThan(legs + 2 * accuracy);
  });
});

/** |t|, with a corner that only its break announces. */
const corner: Curve = {
  dimension: 2,
  domain: [-1, 2],
  breaks: [0],
  point: (t) => [t, Math.abs(t)],
  derivative: (t, r = 1) => (r === 1 ? [1, t < 0 ? -3 : 1] : [0, 0]),
};

test("breaks are respected", () => {
  const expected = Math.sqrt(10) + 2 * Math.SQRT2;
  expect(arclength(corner, 1e-12)).toBeCloseTo(expected, 13);
  let calls = 0;
  const counted: Curve = {
    ...corner,
    derivative: (t, r) => {
      calls++;
      return corner.derivative(t, r);
    },
  };
  arclength(counted, 1e-12);
  expect(calls).toBe(2 * 7 * 13);
  const work = (from: number, to: number): number => {
    calls = 0;
    arclength(counted, 1e-12, from, to);
    return calls;
  };
  expect(work(0, 2)).toBe(7 * 13);
  expect(work(-1, 0)).toBe(7 * 13);
  expect(work(-1, -0.5)).toBe(7 * 13);
  expect(work(2, -1)).toBe(2 * 7 * 13);
  expect(arclength(corner, 1e-12, 2, -1)).toBeCloseTo(-expected, 13);
  expect(arclength(corner, 1e-12, -0.5, 0.5)).toBeCloseTo(0.5 * Math.sqrt(10) + 0.5 * Math.SQRT2, 13);
});

test("the inverse gives the parameter back", () => {
  const inside = fc.double({ min: 0.01, max: 0.99, noNaN: true });
  forAll([points(2, 6, 2), inside], (b, part) => {
    const curve = bezierCurve(b);
    const accuracy = 1e-8 * size(b);
    const length = part * arclength(curve, accuracy / 100);
    const t = parameterAtLength(curve, length, accuracy);
    expect(Math.abs(arclength(curve, accuracy / 100, 0, t) - length)).toBeLessThanOrEqual(1.02 * accuracy);
  });
});

test("the inverse takes a few steps, fewer for a coarser accuracy", () => {
  const curve = bezierCurve(
    [
      [0, 0],
      [1, 3],
      [4, 3],
      [5, 0],
    ],
    [2, 4],
  );
  const whole = arclength(curve, 1e-12);
  const work = [1e-1, 1e-3, 1e-9].map((accuracy) => {
    let calls = 0;
    const counted: Curve = {
      ...curve,
      derivative: (t, r) => {
        calls++;
        return curve.derivative(t, r);
      },
    };
    const t = parameterAtLength(counted, 0.3 * whole, accuracy);
    expect(Math.abs(arclength(curve, 1e-12, 2, t) - 0.3 * whole)).toBeLessThan(accuracy);
    return calls / 91;
  });
  expect(work[0]).toBeLessThan(8);
  expect(work[0]).toBeLessThan(work[1]!);
  expect(work[1]).toBeLessThan(work[2]!);
  expect(work[2]).toBeLessThan(40);
});

test("the inverse at the ends, beyond them, over another domain and past a cusp", () => {
  const line = bezierCurve(
    [
      [0, 0],
      [3, 4],
    ],
    [1, 3],
  );
  expect(parameterAtLength(line, -1, 1e-9)).toBe(1);
  expect(parameterAtLength(line, 0, 1e-9)).toBe(1);
  expect(parameterAtLength(line, 5, 1e-9)).toBe(3);
  expect(parameterAtLength(line, 9, 1e-9)).toBe(3);
  expect(parameterAtLength(line, 1.25, 1e-9)).toBeCloseTo(1.5, 9);
  const cusp = bezierCurve([
    [0, 0],
    [2, 2],
    [0, 2],
    [2, 0],
  ]);
  expect(parameterAtLength(cusp, 3.65685424949238 / 2, 1e-9)).toBeCloseTo(0.5, 3);
  expect(parameterAtLength(bezierCurve([[1, 1]]), 0.5, 1e-9)).toBe(1);
  expect(parameterAtLength(quarter, Math.PI / 2, 1e-10)).toBeCloseTo(0.5, 9);
});

test("the inverse ends where the speed jumps by many orders", () => {
  const steps: Curve = {
    dimension: 1,
    domain: [0, 1],
    breaks: [0.5],
    point: (t) => [t < 0.5 ? 1e-9 * t : 0.5e-9 + 1e9 * (t - 0.5)],
    derivative: (t, r = 1) => [r > 1 ? 0 : t < 0.5 ? 1e-9 : 1e9],
  };
  const t = parameterAtLength(steps, 1, 1e-6);
  expect(Math.abs(arclength(steps, 1e-9, 0, t) - 1)).toBeLessThan(1e-6);
});

test("bad arguments are named", () => {
  const line = bezierCurve([[0], [1]]);
  expect(() => arclength(line, 0)).toThrow("accuracy: expected a positive finite number, got 0");
  expect(() => arclength(line, 1e-9, Number.NaN)).toThrow(/^from: /);
  expect(() => arclength(line, 1e-9, 0, Infinity)).toThrow(/^to: /);
  expect(() => parameterAtLength(line, Number.NaN, 1e-9)).toThrow(/^length: /);
  expect(() => parameterAtLength(line, 0.5, -1)).toThrow(/^accuracy: /);
});
