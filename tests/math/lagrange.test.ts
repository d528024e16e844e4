import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  add,
  barycentricWeights,
  combine,
  distance,
  dividedDifferences,
  dividedDifferenceTable,
  interpolationNodes,
  lagrangeBasis,
  lagrangeBasisDerivative,
  lagrangeCurve,
  lagrangeFunction,
  lagrangePoint,
  lerp,
  monomialCoefficients,
  type NodeKind,
  neville,
  newtonPoint,
  normalizeWeights,
  type Point,
  scale,
} from "../../src/math/index.ts";
import { forAll, point, size } from "./property.ts";

/** Distinct nodes that are not too close, in any order, with as many points. */
const data = fc
  .uniqueArray(fc.integer({ min: -20, max: 20 }), { minLength: 1, maxLength: 7 })
  .chain((whole) =>
    fc.tuple(
      fc.constant(whole.map((k) => k / 4)),
      fc.array(point(2), { minLength: whole.length, maxLength: whole.length }),
    ),
  );
const parameter = fc.double({ min: -5, max: 5, noNaN: true });

/** How much the basis amplifies rounding at t. */
const lebesgue = (nodes: readonly number[], t: number): number =>
  lagrangeBasis(nodes, t).reduce((sum, w) => sum + Math.abs(w), 1);

describe("nodes", () => {
  test("begin and end where they should, ascend and are symmetric", () => {
    const kinds = fc.constantFrom<NodeKind>("equidistant", "chebyshev1", "chebyshev2");
    forAll(
      [kinds, fc.integer({ min: 0, max: 40 }), parameter, fc.double({ min: 0.1, max: 9, noNaN: true })],
      (kind, n, a, width) => {
        const b = a + width;
        const nodes = interpolationNodes(kind, a, b, n);
        expect(nodes.length).toBe(n + 1);
        expect(nodes.every((t, i) => i === 0 || t > nodes[i - 1]!)).toBe(true);
        expect(Math.max(...nodes.map((t, i) => Math.abs(t + nodes[n - i]! - a - b)))).toBeLessThan(1e-13);
        if (kind !== "chebyshev1" && n > 0) expect([nodes[0]! - a, nodes[n]! - b]).toEqual([0, 0]);
      },
    );
  });

  test("are the zeros and extrema of the Chebyshev polynomials", () => {
    const chebyshev = (n: number, x: number) => Math.cos(n * Math.acos(x));
    interpolationNodes("chebyshev1", -1, 1, 6).forEach((x) => {
      expect(chebyshev(7, x)).toBeCloseTo(0, 13);
    });
    interpolationNodes("chebyshev2", -1, 1, 6).forEach((x, i) => {
      expect(chebyshev(6, x)).toBeCloseTo(i % 2 === 0 ? 1 : -1, 13);
    });
    expect(interpolationNodes("equidistant", 2, 4, 4)).toEqual([2, 2.5, 3, 3.5, 4]);
    expect(interpolationNodes("chebyshev2", 2, 4, 0)).toEqual([3]);
  });

  test("bad arguments are named", () => {
    expect(() => interpolationNodes("equidistant", 1, 1, 2)).toThrow(
      "b: expected a number greater than a = 1, got 1",
    );
    expect(() => interpolationNodes("equidistant", Number.NaN, 1, 2)).toThrow(
      "a: expected a finite number, got NaN",
    );
    expect(() => interpolationNodes("equidistant", 0, Number.POSITIVE_INFINITY, 2)).toThrow(
      "b: expected a finite number, got Infinity",
    );
    expect(() => interpolationNodes("equidistant", 0, 1, -1)).toThrow(/^degree: /);
    expect(() => interpolationNodes("gauss" as NodeKind, 0, 1, 1)).toThrow(
      'kind: expected one of equidistant, chebyshev1, chebyshev2, got "gauss"',
    );
  });
});

describe("Lagrange polynomials", () => {
  test("are 1 at their own node and 0 at the others, exactly", () => {
    forAll([data], ([nodes]) => {
      nodes.forEach((t, i) => {
        expect(lagrangeBasis(nodes, t).map(Math.abs)).toEqual(nodes.map((_, j) => (i === j ? 1 : 0)));
      });
    });
  });

  test("add up to 1, their derivatives to 0", () => {
    forAll([data, parameter, fc.integer({ min: 1, max: 3 })], ([nodes], t, r) => {
      const sum = (list: readonly number[]) => list.reduce((s, x) => s + x, 0);
      expect(Math.abs(sum(lagrangeBasis(nodes, t)) - 1)).toBeLessThan(1e-13 * lebesgue(nodes, t));
      const derivative = lagrangeBasisDerivative(nodes, t, r);
      const largest = derivative.reduce((max, x) => Math.max(max, Math.abs(x)), 1);
      expect(Math.abs(sum(derivative))).toBeLessThan(1e-11 * largest);
    });
  });

  test("derivatives of a hand-made cubic basis", () => {
    // Nodes −1, 0, 1: L_0 = t(t−1)/2, L_1 = 1 − t², L_2 = t(t+1)/2.
    expect(lagrangeBasisDerivative([-1, 0, 1], 2, 0)).toEqual([1, -3, 3]);
    expect(lagrangeBasisDerivative([-1, 0, 1], 2)).toEqual([1.5, -4, 2.5]);
    expect(lagrangeBasisDerivative([-1, 0, 1], 2, 2)).toEqual([1, -2, 1]);
    expect(lagrangeBasisDerivative([-1, 0, 1], 2, 3).map(Math.abs)).toEqual([0, 0, 0]);
    expect(lagrangeBasisDerivative([0, 1, 2, 3], 5, 3)).toEqual([-1, 3, -3, 1]);
  });

  test("bad arguments are named", () => {
    expect(() => lagrangeBasis([], 0)).toThrow("nodes: expected at least 1 number, got none");
    expect(() => lagrangeBasis([0, 1, 0], 0)).toThrow(
      "nodes[2]: expected a value different from nodes[0], got 0",
    );
    expect(() => lagrangeBasis([0, 1], Number.NaN)).toThrow("t: expected a finite number, got NaN");
    expect(() => lagrangeBasisDerivative([1, 1], 0)).toThrow(/^nodes\[1\]: /);
    expect(() => lagrangeBasisDerivative([0, 1], Number.NaN)).toThrow(/^t: /);
    expect(() => lagrangeBasisDerivative([0, 1], 0, 0.5)).toThrow(/^r: /);
  });
});

describe("interpolation", () => {
  test("meets every point at its node, exactly", () => {
    forAll([data], ([nodes, points]) => {
      const curve = lagrangeCurve(nodes, points);
      nodes.forEach((t, i) => {
        expect(curve.point(t)).toEqual(points[i]);
      });
      expect(curve.dimension).toBe(2);
    });
  });

  test("barycentric, product, Newton, Neville and monomial forms agree", () => {
    forAll([data, parameter], ([nodes, points], t) => {
      const p = lagrangeCurve(nodes, points).point(t);
      const tolerance = 1e-10 * size(points) * lebesgue(nodes, t);
      expect(distance(p, combine(lagrangeBasis(nodes, t), points))).toBeLessThan(tolerance);
      expect(distance(p, newtonPoint(nodes, dividedDifferences(nodes, points), t))).toBeLessThan(tolerance);
      expect(distance(p, neville(nodes, points, t).at(-1)![0]!)).toBeLessThan(tolerance);
      expect(distance(p, lagrangePoint(nodes, points, t))).toBeLessThan(tolerance);
      const a = monomialCoefficients(nodes, points);
      const power = a.reduceRight((sum: Point, c) => add(scale(sum, t), c), [0, 0]);
      expect(distance(p, power)).toBeLessThan(1e5 * tolerance);
    });
  });

  test("a polynomial of fitting degree is reproduced, with its derivatives", () => {
    const f = (x: number) => 2 - x + 3 * x ** 2 - 0.5 * x ** 3;
    const p = lagrangeFunction([3, -1, 0.5, 2, 4], [3, -1, 0.5, 2, 4].map(f));
    forAll([parameter], (t) => {
      expect(p(t)).toBeCloseTo(f(t), 10);
      expect(p(t, 1)).toBeCloseTo(-1 + 6 * t - 1.5 * t ** 2, 9);
      expect(p(t, 2)).toBeCloseTo(6 - 3 * t, 9);
      expect(p(t, 3)).toBeCloseTo(-3, 8);
    });
    expect(lagrangePoint([0, 1, 2], [[0], [1], [4]], 5, 1)).toEqual([10]);
  });

  test("does not depend on the order of the data", () => {
    forAll([data, parameter], ([nodes, points], t) => {
      const turned = lagrangeCurve([...nodes].reverse(), [...points].reverse());
      const difference = distance(turned.point(t), lagrangeCurve(nodes, points).point(t));
      expect(difference).toBeLessThan(1e-12 * size(points) * lebesgue(nodes, t));
    });
  });

  test("the curve's domain is the interval of the nodes, its pieces keep points and parameters", () => {
    const curve = lagrangeCurve(
      [3, -1, 2],
      [
        [0, 0],
        [1, 2],
        [5, 5],
      ],
    );
    expect(curve.domain).toEqual([-1, 3]);
    expect(lagrangeCurve([3], [[7, 8]]).domain).toEqual([3, 4]);
    expect(lagrangeCurve([3], [[7, 8]]).point(3.5)).toEqual([7, 8]);
    expect(lagrangeCurve([3], [[7, 8]]).derivative(3.5)).toEqual([0, 0]);
    const [left, right] = curve.split!(1);
    expect([left.domain, right.domain]).toEqual([
      [-1, 1],
      [1, 3],
    ]);
    expect(left.point(0.5)).toEqual(curve.point(0.5));
    expect(right.split!(2)[0].domain).toEqual([1, 2]);
    expect(right.split!(2)[1].domain).toEqual([2, 3]);
    expect(curve.derivative(0.5)).toEqual(curve.derivative(0.5, 1));
    expect(curve.derivative(0.5, 0)).toEqual(curve.point(0.5));
  });

  test("stays accurate on 61 equidistant nodes, where the quotient form does not", () => {
    const nodes = interpolationNodes("equidistant", -1, 1, 60);
    const p = lagrangeFunction(
      nodes,
      nodes.map((x) => 1 + x - 2 * x ** 2),
    );
    for (const t of [-0.99, -0.3, 0.5, 0.983]) {
      const size = lebesgue(nodes, t);
      expect(Math.abs(p(t) - (1 + t - 2 * t ** 2))).toBeLessThan(1e-15 * 60 * size);
    }
  });

  test("the weights hold on intervals of any length", () => {
    for (const unit of [1e-60, 1, 1e60]) {
      const nodes = interpolationNodes("chebyshev1", 0, unit, 11);
      const p = lagrangeFunction(
        nodes,
        nodes.map((x) => (x / unit) ** 2),
      );
      expect(p(0.3 * unit)).toBeCloseTo(0.09, 13);
    }
  });

  test("bad arguments are named", () => {
    expect(() => lagrangeCurve([0, 0], [[1], [2]])).toThrow(/^nodes\[1\]: /);
    expect(() => lagrangeCurve([0, 1], [[1]])).toThrow(
      "points: expected 2 entries, one for each of nodes, got 1",
    );
    expect(() => lagrangeCurve([0, 1], [[1], [2, 3]])).toThrow(/^points\[1\]: /);
    expect(() => lagrangeFunction([0, 1], [1, Number.NaN])).toThrow(/^values\[1\]: /);
    expect(() => lagrangePoint([0], [[1]], Number.NaN)).toThrow(/^t: /);
    expect(() => lagrangePoint([0], [[1]], 0, -1)).toThrow(/^r: /);
    expect(() => lagrangePoint([0], [], 0)).toThrow(/^points: /);
    const many = interpolationNodes("equidistant", 0, 1, 1500);
    expect(() => lagrangeFunction(many, many)).toThrow(
      /^nodes: expected barycentric weights within the range of doubles, got -?(0|Infinity) at index \d+; take fewer nodes or Chebyshev nodes$/,
    );
    expect(() => barycentricWeights([0, 1e-200, 2e-200])).toThrow("got Infinity at index 0");
    expect(() => barycentricWeights([0, 1e200, 2e200])).toThrow("got 0 at index 0");
  });
});

describe("barycentric weights", () => {
  test("make the Lagrange polynomials: L_i(t) = l(t)·w_i/(t − t_i)", () => {
    forAll([data, parameter], ([nodes], t) => {
      fc.pre(nodes.every((node) => Math.abs(t - node) > 1e-3));
      const w = barycentricWeights(nodes);
      const l = nodes.reduce((product, node) => product * (t - node), 1);
      const tolerance = 1e-12 * lebesgue(nodes, t);
      lagrangeBasis(nodes, t).forEach((value, i) => {
        expect(Math.abs((l * w[i]!) / (t - nodes[i]!) - value)).toBeLessThan(tolerance);
      });
    });
  });

  test("normalized, the largest is ±1", () => {
    expect(normalizeWeights(barycentricWeights([0, 1, 2]))).toEqual([-0.5, 1, -0.5].map((w) => -w));
    expect(barycentricWeights([0, 1, 2])).toEqual([0.5, -1, 0.5]);
    expect(() => barycentricWeights([1, 1])).toThrow(/^nodes\[1\]: /);
  });
});

describe("Newton and Neville", () => {
  test("a new node at the end leaves the old table as it was", () => {
    forAll([data], ([nodes, points]) => {
      fc.pre(nodes.length > 1);
      const table = dividedDifferenceTable(nodes, points);
      const shorter = dividedDifferenceTable(nodes.slice(0, -1), points.slice(0, -1));
      expect(table.slice(0, -1).map((row) => row.slice(0, -1))).toEqual(shorter);
    });
  });

  test("a table by hand", () => {
    expect(dividedDifferenceTable([0, 1, 3], [[1], [2], [10]])).toEqual([
      [[1], [2], [10]],
      [[1], [4]],
      [[1]],
    ]);
    expect(dividedDifferences([0, 1, 3], [[1], [2], [10]])).toEqual([[1], [1], [1]]);
    expect(monomialCoefficients([0, 1, 3], [[1], [2], [10]])).toEqual([[1], [0], [1]]);
    expect(newtonPoint([0, 1, 3], [[1], [1], [1]], 2)).toEqual([5]);
    expect(neville([0, 1, 3], [[1], [2], [10]], 2)).toEqual([[[1], [2], [10]], [[3], [6]], [[5]]]);
  });

  test("each entry of Neville's scheme lies on the line of the two above", () => {
    forAll([data, parameter], ([nodes, points], t) => {
      const levels = neville(nodes, points, t);
      expect(levels.map((level) => level.length)).toEqual(nodes.map((_, r) => nodes.length - r));
      for (let r = 1; r < levels.length; r++) {
        levels[r]!.forEach((entry, i) => {
          const share = (t - nodes[i]!) / (nodes[i + r]! - nodes[i]!);
          expect(entry).toEqual(lerp(levels[r - 1]![i]!, levels[r - 1]![i + 1]!, share));
        });
      }
    });
  });

  test("bad arguments are named", () => {
    expect(() => dividedDifferences([0, 0], [[1], [2]])).toThrow(/^nodes\[1\]: /);
    expect(() => dividedDifferences([0, 1], [[1], []])).toThrow(/^points\[1\]: /);
    expect(() => dividedDifferences([0, 1], [[1]])).toThrow(/^points: expected 2 entries/);
    expect(() => newtonPoint([0], [], 0)).toThrow(/^coefficients: /);
    expect(() => newtonPoint([], [[1]], 0)).toThrow(/^nodes: expected 1 entries/);
    expect(() => newtonPoint([0], [[1]], Number.NaN)).toThrow(/^t: /);
    expect(() => neville([1, 1], [[1], [2]], 0)).toThrow(/^nodes\[1\]: /);
    expect(() => neville([0, 1], [[1], [Number.NaN]], 0)).toThrow(/^points\[1\]\[0\]: /);
    expect(() => neville([0, 1], [[1]], 0)).toThrow(/^points: expected 2 entries/);
    expect(() => neville([0], [[1]], Number.NaN)).toThrow(/^t: /);
  });
});
