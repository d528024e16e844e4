import fc from "fast-check";
import { expect, test } from "vitest";
import { findRoot } from "../../src/math/index.ts";
import { forAll } from "./property.ts";

const inner = fc.double({ min: -0.9, max: 0.9, noNaN: true });

test("finds the change of sign of functions of all shapes", () => {
  const shapes: ((x: number) => number)[] = [
    (x) => x,
    (x) => x ** 3,
    (x) => x ** 9,
    (x) => Math.sign(x),
    (x) => Math.expm1(20 * x),
    (x) => -Math.atan(1e6 * x),
    (x) => Math.cbrt(x),
    (x) => (x < 0 ? -Infinity : Infinity),
    (x) => (x < 0 ? -1 : Infinity),
  ];
  forAll([inner, fc.constantFrom(...shapes), fc.boolean()], (root, shape, flip) => {
    const f = (t: number) => shape(t - root);
    const found = flip ? findRoot(f, 1, -1, 1e-9) : findRoot(f, -1, 1, 1e-9);
    expect(Math.abs(found - root)).toBeLessThan(1e-9);
  });
});

test("an accuracy of 0 reaches neighbouring doubles", () => {
  const root = findRoot((t) => t * t - 2, 0, 2, 0);
  expect(Math.abs(root - Math.SQRT2)).toBeLessThanOrEqual(2 ** -52);
});

test("over an interval far from 0 and one around it, the work is the same", () => {
  const work = [-1, 0, 1e6].map((start) => {
    let calls = 0;
    const root = findRoot(
      (t) => {
        calls++;
        return Math.expm1(9 * (t - start - 0.7));
      },
      start,
      start + 1,
      1e-6,
    );
    expect(Math.abs(root - start - 0.7)).toBeLessThan(1e-6);
    return calls;
  });
  expect(Math.max(...work) - Math.min(...work)).toBeLessThanOrEqual(1);
});

test("an end that is a zero is the answer", () => {
  expect(findRoot((t) => t, 0, 1, 1e-9)).toBe(0);
  expect(findRoot((t) => t - 1, 0, 1, 1e-9)).toBe(1);
});

test("smooth functions take few steps, flat ones not many more than bisection", () => {
  const count = (f: (t: number) => number, a: number, b: number) => {
    let calls = 0;
    findRoot(
      (t) => {
        calls++;
        return f(t);
      },
      a,
      b,
      1e-12,
    );
    return calls;
  };
  expect(count((t) => Math.cos(t) - t, 0, 1)).toBeLessThan(14);
  expect(count((t) => 2 * t - 0.7, 0, 1)).toBeLessThan(5);
  expect(count((t) => (t - 0.3) ** 15, -1, 2)).toBeLessThan(140);
  expect(count((t) => Math.sign(t - 0.123), -1, 2)).toBeLessThan(130);
});

test("no change of sign, no number: an error that names it", () => {
  expect(() => findRoot((t) => t * t + 1, -1, 2, 1e-9)).toThrow(
    "f: expected values of opposite sign at -1 and 2, got 2 and 5",
  );
  expect(() => findRoot((t) => -t * t - 1, -1, 2, 1e-9)).toThrow(RangeError);
  expect(() => findRoot((t) => t, Number.NaN, 1, 0)).toThrow(/^a: /);
  expect(() => findRoot((t) => t, -1, Infinity, 0)).toThrow(/^b: /);
});
