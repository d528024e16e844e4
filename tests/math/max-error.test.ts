import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  interpolationNodes,
  lagrangeFunction,
  maxError,
  maxErrorSampled,
  runge,
  rungeDerivative,
} from "../../src/math/index.ts";
import { forAll } from "./property.ts";

const interpolant = (kind: "equidistant" | "chebyshev1", degree: number) => {
  const nodes = interpolationNodes(kind, -5, 5, degree);
  return lagrangeFunction(nodes, nodes.map(runge));
};

describe("Runge's function", () => {
  test("has the stated derivative", () => {
    forAll([fc.double({ min: -9, max: 9, noNaN: true })], (x) => {
      const e = 1e-5;
      expect(rungeDerivative(x)).toBeCloseTo((runge(x + e) - runge(x - e)) / (2 * e), 8);
    });
    expect(runge(2)).toBe(0.2);
    expect(rungeDerivative(1)).toBe(-0.5);
    expect(rungeDerivative(1e200)).toBeCloseTo(0);
  });

  test("the lecture's errors: 0.4384, 0.2474, 7.1949 for degrees 4, 7, 14", () => {
    const peaks = [4, 7, 14].map((degree) => maxError(runge, interpolant("equidistant", degree), -5, 5));
    expect(peaks.map(({ error }) => error.toFixed(4))).toEqual(["0.4384", "0.2474", "7.1949"]);
    expect(Math.abs(peaks[0]!.at)).toBeCloseTo(3.97, 2);
    expect(peaks[1]!.at).toBeCloseTo(0, 6);
    expect(Math.abs(peaks[2]!.at)).toBeCloseTo(4.81, 2);
    const chebyshev = [4, 7, 14].map(
      (degree) => maxError(runge, interpolant("chebyshev1", degree), -5, 5).error,
    );
    expect(chebyshev.map((error) => error.toFixed(3))).toEqual(["0.402", "0.392", "0.047"]);
    expect(interpolant("equidistant", 14)(-5, 1)).toBeCloseTo(92.6, 1);
  });
});

describe("maxError", () => {
  const zero = () => 0;

  test("finds a peak between the samples", () => {
    forAll([fc.double({ min: -0.9, max: 0.9, noNaN: true })], (top) => {
      const { error, at } = maxError((x) => 3 - (x - top) ** 2, zero, -1, 1, 10);
      expect(error).toBeCloseTo(3, 13);
      expect(at).toBeCloseTo(top, 6);
    });
  });

  test("finds the highest of several peaks, and one below zero", () => {
    const { error, at } = maxError(zero, (x) => x * Math.sin(10 * x), 0, 3, 50);
    // The last peak lies between the last two samples, of which the end is the higher one.
    expect(at).toBeCloseTo(2.9879, 3);
    expect(error).toBeCloseTo(at * Math.abs(Math.sin(10 * at)), 14);
    expect(error).toBeCloseTo(2.98618, 4);
  });

  test("takes the ends of the interval", () => {
    expect(maxError((x) => x, zero, 0, 3, 7)).toEqual({ error: 3, at: 3 });
    expect(maxError((x) => -x, zero, -3, 0, 7)).toEqual({ error: 3, at: -3 });
    expect(maxError((x) => x / 3, zero, 0, 0.3, 3).at).toBe(0.3);
    expect(maxError(zero, zero, 0, 1)).toEqual({ error: 0, at: 0 });
  });

  test("over samples it is the largest of them, the first of equal ones", () => {
    expect(
      maxErrorSampled(
        (x) => x,
        (x) => x * x,
        [0, 0.25, 0.5, 2, -1],
      ),
    ).toEqual({ error: 2, at: 2 });
    expect(maxErrorSampled(zero, zero, [4, 5])).toEqual({ error: 0, at: 4 });
  });

  test("bad arguments are named", () => {
    expect(() => maxError(zero, zero, 1, 0)).toThrow("b: expected a number greater than a = 1, got 0");
    expect(() => maxError(zero, zero, 0, 1, 1)).toThrow(/^samples: /);
    expect(() => maxErrorSampled(zero, zero, [])).toThrow(/^positions: /);
  });
});
