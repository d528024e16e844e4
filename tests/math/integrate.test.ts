import fc from "fast-check";
import { expect, test } from "vitest";
import { gaussLobatto } from "../../src/math/gauss-lobatto.ts";
import { integrate } from "../../src/math/index.ts";
import { forAll } from "./property.ts";

test("the rule with n points, ends included, integrates polynomials up to degree 2n − 3", () => {
  for (const n of [2, 3, 5, 13, 40]) {
    const { nodes, weights } = gaussLobatto(n);
    expect([...nodes].sort((a, b) => a - b)).toEqual(nodes);
    expect([nodes[0], nodes.at(-1)]).toEqual([-1, 1]);
    for (let k = 0; k <= 2 * n - 3; k++) {
      const sum = nodes.reduce((total, x, i) => total + weights[i]! * x ** k, 0);
      expect(sum).toBeCloseTo(k % 2 === 0 ? 2 / (k + 1) : 0, 12);
    }
  }
});

test("smooth functions, to the last digits", () => {
  expect(integrate(Math.exp, 0, 1, 1e-12)).toBeCloseTo(Math.E - 1, 14);
  expect(integrate(Math.exp, 1, 0, 1e-12)).toBeCloseTo(1 - Math.E, 14);
  expect(integrate(Math.sin, 0, 30 * Math.PI + 1, 1e-12)).toBeCloseTo(1 - Math.cos(1), 11);
  expect(integrate((x) => 1 / (1 + x * x), -5, 5, 1e-12)).toBeCloseTo(2 * Math.atan(5), 12);
  expect(integrate(() => 7, 2, 2, 1e-12)).toBe(0);
});

test("kinks, at the accuracy asked for and not much more work", () => {
  // Anywhere, or close to the points where intervals are halved.
  const offset = fc.integer({ min: -12, max: -2 }).map((exponent) => 10 ** exponent);
  const place = fc.oneof(
    fc.double({ min: -0.99, max: 0.99, noNaN: true }),
    fc.tuple(fc.constantFrom(-0.5, 0, 0.25), offset, fc.constantFrom(-1, 1)).map(([x, d, s]) => x + s * d),
  );
  forAll([place, fc.constantFrom(1e-4, 1e-8, 1e-12)], (kink, accuracy) => {
    let calls = 0;
    const f = (x: number) => {
      calls++;
      return Math.abs(x - kink);
    };
    const exact = ((1 - kink) ** 2 + (1 + kink) ** 2) / 2;
    expect(Math.abs(integrate(f, -1, 1, accuracy) - exact)).toBeLessThanOrEqual(accuracy + 1e-14);
    expect(calls).toBeLessThan(3000);
  });
});

test("one agreement by chance is not taken for accuracy", () => {
  // With this kink the rule on the whole and on the two halves agree to the last digit, both wrong by 0.0012.
  const kink = 0.42805414241663975;
  const exact = ((1 - kink) ** 2 + (1 + kink) ** 2) / 2;
  expect(Math.abs(integrate((x) => Math.abs(x - kink), -1, 1, 1e-6) - exact)).toBeLessThan(1e-6);
});

test("an odd function away from the middle", () => {
  expect(integrate((x) => x ** 3, 1, 3, 1e-9)).toBeCloseTo(20, 12);
  expect(integrate((x) => x - 2, 1, 4, 1e-9)).toBeCloseTo(1.5, 12);
});

test("a jump ends, and an accuracy below rounding too", () => {
  expect(integrate((x) => (x < 0.3 ? 1 : 0), 0, 1, 1e-14)).toBeCloseTo(0.3, 13);
  let calls = 0;
  const value = integrate(
    (x) => {
      calls++;
      return 1e9 * Math.exp(x);
    },
    0,
    1,
    1e-30,
  );
  expect(value / 1e9).toBeCloseTo(Math.E - 1, 13);
  expect(calls).toBeLessThan(1e5);
});

test("bad arguments are named", () => {
  expect(() => integrate(Math.sin, Number.NaN, 1, 1e-9)).toThrow(/^a: /);
  expect(() => integrate(Math.sin, 0, Infinity, 1e-9)).toThrow(/^b: /);
  expect(() => integrate(Math.sin, 0, 1, 0)).toThrow("accuracy: expected a positive finite number, got 0");
});
