import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { bernsteinAll, bernsteinProduct, bernsteinRoots } from "../../src/math/index.ts";
import { coordinate, forAll, unit } from "./property.ts";

/** The Bernstein coefficients of Π (t − root). */
function withRoots(...roots: number[]): number[] {
  return roots.reduce((product, root) => bernsteinProduct(product, [-root, 1 - root]), [1]);
}

const value = (coefficients: readonly number[], t: number): number =>
  bernsteinAll(coefficients.length - 1, t).reduce((sum, b, i) => sum + b * coefficients[i]!, 0);

describe("bernsteinRoots", () => {
  test("simple zeros change the sign", () => {
    expect(bernsteinRoots([-1, 1])).toEqual([{ t: 0.5, signChange: true }]);
    const roots = bernsteinRoots(withRoots(0.2, 0.5, 0.9));
    expect(roots.map((root) => root.signChange)).toEqual([true, true, true]);
    for (const [i, t] of [0.2, 0.5, 0.9].entries()) expect(roots[i]!.t).toBeCloseTo(t, 13);
  });

  test("double zeros do not, triple ones do, and both are found once and exactly", () => {
    const cases: [number[], boolean[]][] = [
      [[0.3, 0.3], [false]],
      [[0.3, 0.3, 0.3], [true]],
      [[0.3, 0.3, 0.3, 0.3], [false]],
      [
        [0.3, 0.3, 0.7],
        [false, true],
      ],
      [
        [0.25, 0.25, 0.75, 0.75],
        [false, false],
      ],
    ];
    for (const [zeros, changes] of cases) {
      const roots = bernsteinRoots(withRoots(...zeros));
      expect(roots.map((root) => root.signChange)).toEqual(changes);
      [...new Set(zeros)].forEach((t, i) => {
        expect(roots[i]!.t).toBeCloseTo(t, 12);
      });
    }
  });

  test("zeros at the ends are reported there, without change of sign", () => {
    expect(bernsteinRoots([0, 1])).toEqual([{ t: 0, signChange: false }]);
    expect(bernsteinRoots([1, 0])).toEqual([{ t: 1, signChange: false }]);
    expect(bernsteinRoots([1e-17, 1, 1e-17])).toEqual([
      { t: 0, signChange: false },
      { t: 1, signChange: false },
    ]);
    expect(bernsteinRoots(withRoots(0, 0.5, 1)).map((root) => root.signChange)).toEqual([false, true, false]);
  });

  test("zeros too close to be told apart are one, in their middle", () => {
    const three = bernsteinRoots(withRoots(0.5 - 1e-5, 0.5, 0.5 + 1e-5));
    expect(three).toHaveLength(1);
    expect(three[0]!.signChange).toBe(true);
    expect(three[0]!.t).toBeCloseTo(0.5, 9);
    const two = bernsteinRoots(withRoots(0.3 - 1e-7, 0.3 + 1e-7, 0.8));
    expect(two.map((root) => root.signChange)).toEqual([false, true]);
    expect(two[0]!.t).toBeCloseTo(0.3, 9);
    const atEnds = bernsteinRoots(withRoots(1e-7, 1e-7, 1e-7, 1 - 1e-7, 1 - 1e-7, 1 - 1e-7));
    expect(atEnds).toEqual([
      { t: 0, signChange: false },
      { t: 1, signChange: false },
    ]);
  });

  test("zeros outside [0, 1] and none at all", () => {
    expect(bernsteinRoots(withRoots(-0.1, 1.1))).toEqual([]);
    expect(bernsteinRoots([1, -0.2, 1])).toEqual([]);
    expect(bernsteinRoots([3])).toEqual([]);
    expect(bernsteinRoots([0, 0, 0])).toEqual([]);
    expect(bernsteinRoots([2, 2, 2])).toEqual([]);
  });

  test("does not depend on the size of the coefficients", () => {
    for (const factor of [1e-200, 1e200, -1]) {
      const roots = bernsteinRoots(withRoots(0.2, 0.6).map((c) => factor * c));
      expect(roots).toHaveLength(2);
      expect(roots[0]!.t).toBeCloseTo(0.2, 13);
      expect(roots[1]!.t).toBeCloseTo(0.6, 13);
    }
  });

  test("finds all zeros of a product of linear factors", () => {
    const grid = fc.uniqueArray(fc.integer({ min: 1, max: 29 }), { minLength: 1, maxLength: 6 });
    forAll([grid], (numbers) => {
      const zeros = numbers.map((k) => k / 30).sort((a, b) => a - b);
      const roots = bernsteinRoots(withRoots(...zeros));
      expect(roots).toHaveLength(zeros.length);
      for (const [i, root] of roots.entries()) {
        expect(root.signChange).toBe(true);
        expect(Math.abs(root.t - zeros[i]!)).toBeLessThan(1e-8);
      }
    });
  });

  test("between two zeros the sign is constant, and changes as said", () => {
    const sparse = fc.array(coordinate, { minLength: 2, maxLength: 8 });
    forAll([sparse], (coefficients) => {
      const largest = Math.max(...coefficients.map(Math.abs));
      fc.pre(largest > 0 && new Set(coefficients).size > 1);
      const roots = bernsteinRoots(coefficients);
      const stops = [0, ...roots.map((root) => root.t), 1];
      let sign = 0;
      for (let i = 1; i < stops.length; i++) {
        const changes = roots[i - 2]?.signChange ?? false;
        for (const part of [0.3, 0.5, 0.7]) {
          const here = value(coefficients, stops[i - 1]! + part * (stops[i]! - stops[i - 1]!));
          if (Math.abs(here) < 1e-9 * largest) continue;
          const expected = changes ? -sign : sign;
          if (part === 0.3 && sign !== 0) expect(Math.sign(here)).toBe(expected);
          else if (sign !== 0 && part !== 0.3 && !changes) expect(Math.sign(here)).toBe(sign);
          sign = Math.sign(here);
          break;
        }
      }
    });
  });
});

test("the product of two polynomials", () => {
  expect(bernsteinProduct([0, 1], [0, 1])).toEqual([0, 0, 1]);
  expect(bernsteinProduct([0, 1], [1, 0])).toEqual([0, 0.5, 0]);
  expect(bernsteinProduct([2], [3, 4])).toEqual([6, 8]);
  const polynomial = fc.array(coordinate, { minLength: 1, maxLength: 6 });
  forAll([polynomial, polynomial, unit], (f, g, t) => {
    const bound = 1e-12 * Math.max(1, ...f.map(Math.abs)) * Math.max(1, ...g.map(Math.abs));
    expect(Math.abs(value(bernsteinProduct(f, g), t) - value(f, t) * value(g, t))).toBeLessThan(bound);
  });
});

test("bad arguments are named", () => {
  expect(() => bernsteinRoots([])).toThrow("coefficients: expected at least 1 number, got none");
  expect(() => bernsteinRoots([0, Number.NaN])).toThrow(/^coefficients\[1\]/);
  expect(() => bernsteinProduct([], [1])).toThrow(/^f: /);
  expect(() => bernsteinProduct([1], [Infinity])).toThrow(/^g\[0\]/);
});
