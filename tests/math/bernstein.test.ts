import fc from "fast-check";
import { expect, test } from "vitest";
import { bernstein, bernsteinAll, bernsteinDerivative, binomial } from "../../src/math/index.ts";
import { forAll, unit } from "./property.ts";

const degree = fc.integer({ min: 0, max: 30 });

test("binomial coefficients", () => {
  expect([0, 1, 2, 3, 4].map((k) => binomial(4, k))).toEqual([1, 4, 6, 4, 1]);
  expect([binomial(0, 0), binomial(3, -1), binomial(3, 4)]).toEqual([1, 0, 0]);
  expect(binomial(50, 25)).toBe(126410606437752);
  expect(() => binomial(-1, 0)).toThrow("n: expected a whole number of at least 0, got -1");
  forAll([fc.integer({ min: 1, max: 50 }), fc.integer({ min: 0, max: 50 })], (n, k) => {
    expect(binomial(n, k)).toBe(binomial(n - 1, k - 1) + binomial(n - 1, k));
  });
});

test("the cubic polynomials at 1/4", () => {
  expect(bernsteinAll(3, 0.25)).toEqual([27 / 64, 27 / 64, 9 / 64, 1 / 64]);
  expect(bernsteinAll(0, 0.3)).toEqual([1]);
  expect([bernstein(3, -1, 0.5), bernstein(3, 4, 0.5)]).toEqual([0, 0]);
});

test("they are the polynomial outside [0, 1] too", () => {
  expect(bernstein(2, 1, 2)).toBe(-4);
  expect(bernstein(3, 3, -1)).toBe(-1);
  expect(bernstein(4, 1, 3)).toBe(-96);
});

test("they add up to 1 and lie in [0, 1]", () => {
  forAll([degree, unit], (n, t) => {
    const all = bernsteinAll(n, t);
    expect(Math.abs(all.reduce((sum, value) => sum + value, 0) - 1)).toBeLessThan(1e-13);
    for (const value of all) {
      expect(value).toBeGreaterThanOrEqual(0);
      expect(value).toBeLessThanOrEqual(1);
    }
  });
});

test("symmetry B_i^n(t) = B_{n−i}^n(1 − t)", () => {
  forAll([degree, unit], (n, t) => {
    const mirrored = bernsteinAll(n, 1 - (1 - t)).reverse();
    bernsteinAll(n, 1 - t).forEach((value, i) => {
      expect(Math.abs(value - mirrored[i]!)).toBeLessThan(1e-13);
    });
  });
});

test("recursion B_i^n = (1 − t) B_i^{n−1} + t B_{i−1}^{n−1}", () => {
  forAll([fc.integer({ min: 1, max: 30 }), fc.integer({ min: 0, max: 30 }), unit], (n, i, t) => {
    const sum = (1 - t) * bernstein(n - 1, i, t) + t * bernstein(n - 1, i - 1, t);
    expect(Math.abs(bernstein(n, i, t) - sum)).toBeLessThanOrEqual(1e-13 * sum + 1e-300);
  });
});

test("high degrees stay finite and add up to 1", () => {
  for (const n of [1030, 3000]) {
    for (const t of [0, 1e-9, 0.24, 0.5, 1]) {
      const all = bernsteinAll(n, t);
      expect(all.every(Number.isFinite)).toBe(true);
      expect(all.reduce((sum, value) => sum + value, 0)).toBeCloseTo(1, 10);
    }
  }
});

test("derivatives", () => {
  expect(bernsteinDerivative(3, 0, 0)).toBe(-3);
  expect(bernsteinDerivative(3, 1, 0)).toBe(3);
  expect(bernsteinDerivative(3, 1, 0, 0)).toBe(0);
  expect(bernsteinDerivative(3, 3, 0.5, 2)).toBe(3);
  expect(bernsteinDerivative(3, 3, 0.5, 3)).toBe(6);
  expect(bernsteinDerivative(3, 3, 0.5, 4)).toBe(0);
  expect(bernsteinDerivative(0, 0, 0.5)).toBe(0);
  forAll([fc.integer({ min: 1, max: 12 }), unit], (n, t) => {
    const h = 1e-4;
    for (let i = 0; i <= n; i++) {
      const difference = (bernstein(n, i, t + h) - bernstein(n, i, t - h)) / (2 * h);
      expect(Math.abs(bernsteinDerivative(n, i, t) - difference)).toBeLessThan(1e-8 * n ** 3);
    }
  });
});

test("bad arguments are named", () => {
  expect(() => bernstein(1.5, 0, 0)).toThrow("n: expected a whole number of at least 0, got 1.5");
  expect(() => bernstein(2, 0.5, 0)).toThrow(/^i: expected a whole number/);
  expect(() => bernstein(2, 0, Number.NaN)).toThrow("t: expected a finite number, got NaN");
  expect(() => bernsteinAll(-1, 0)).toThrow(/^n: /);
  expect(() => bernsteinAll(1, Infinity)).toThrow(/^t: /);
  expect(() => bernsteinDerivative(2, 0, 0, -1)).toThrow("r: expected a whole number of at least 0, got -1");
  expect(() => bernsteinDerivative(-1, 0, 0)).toThrow(/^n: /);
});
