import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  bezierPoint,
  bezierToHermite,
  combine,
  distance,
  hermiteBasis,
  hermiteBasisCoefficients,
  hermiteBasisCurve,
  hermiteCoefficientMatrix,
  hermiteCoefficients,
  hermiteCubicBasis,
  hermiteCubicBasisPointsFirst,
  hermiteCurve,
  hermiteMatrix,
  hermitePoint,
  hermiteToBezier,
  identity4,
  invert4,
  multiply4,
  type Point,
} from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

const geometry = fc.tuple(point(3), point(3), point(3), point(3));
const powers = (t: number, n: number) => Array.from({ length: n }, (_, k) => t ** k);

describe("the cubic basis", () => {
  test("derivatives are those of the polynomials", () => {
    const e = 1e-5;
    forAll([unit, fc.integer({ min: 0, max: 3 })], (t, r) => {
      const numeric = hermiteCubicBasis(t + e, r).map(
        (x, i) => (x - hermiteCubicBasis(t - e, r)[i]!) / (2 * e),
      );
      hermiteCubicBasis(t, r + 1).forEach((x, i) => {
        expect(x).toBeCloseTo(numeric[i]!, 5);
      });
    });
    expect(hermiteCubicBasis(0.3, 4)).toEqual([0, 0, 0, 0]);
  });

  test("H_0 + H_3 = 1, H_2 reaches −4/27 at 2/3, both orders hold the same functions", () => {
    forAll([unit, fc.integer({ min: 0, max: 3 })], (t, r) => {
      const [h0, h1, h2, h3] = hermiteCubicBasis(t, r);
      expect(h0 + h3).toBeCloseTo(r === 0 ? 1 : 0, 14);
      expect(hermiteCubicBasisPointsFirst(t, r)).toEqual([h0, h3, h1, h2]);
    });
    expect(hermiteCubicBasis(2 / 3)[2]).toBeCloseTo(-4 / 27, 15);
  });
});

describe("the cubic segment", () => {
  test("has the given ends and end tangents, exactly", () => {
    forAll([geometry], ([p0, m0, m1, p1]) => {
      const at = (t: number, r: number) => hermitePoint(p0, m0, m1, p1, t, r).map((x) => x + 0);
      expect(at(0, 0)).toEqual(p0.map((x) => x + 0));
      expect(at(1, 0)).toEqual(p1.map((x) => x + 0));
      expect(at(0, 1)).toEqual(m0.map((x) => x + 0));
      expect(at(1, 1)).toEqual(m1.map((x) => x + 0));
    });
  });

  test("coefficients, Bézier form and K⁻¹·G describe the same curve", () => {
    forAll([geometry, unit], ([p0, m0, m1, p1], t) => {
      const p = hermitePoint(p0, m0, m1, p1, t);
      const row = [t ** 3, t ** 2, t, 1];
      const tolerance = 1e-13 * size([p0, m0, m1, p1]);
      expect(distance(p, combine(row, hermiteCoefficients(p0, m0, m1, p1)))).toBeLessThan(tolerance);
      expect(distance(p, bezierPoint(hermiteToBezier(p0, m0, m1, p1), t))).toBeLessThan(tolerance);
      const c = hermiteCoefficientMatrix(0, 1, [p0, p1, m0, m1]);
      expect(distance(p, combine(row, c))).toBeLessThan(tolerance);
    });
  });

  test("to Bézier and back", () => {
    forAll([geometry], (g) => {
      bezierToHermite(hermiteToBezier(...g)).forEach((row, i) => {
        expect(distance(row, g[i]!)).toBeLessThan(1e-12 * size(g));
      });
    });
    expect(bezierToHermite([[0], [1], [3], [4]])).toEqual([[0], [3], [3], [4]]);
  });

  test("bad arguments are named", () => {
    const p: Point = [0, 0];
    expect(() => hermitePoint(p, p, [1], p, 0)).toThrow("m1: expected 2 coordinates, got [1]");
    expect(() => hermitePoint(p, p, p, p, Number.NaN)).toThrow(/^t: /);
    expect(() => hermiteCoefficients(p, p, p, [Number.NaN, 0])).toThrow(/^p1\[0\]: /);
    expect(() => hermiteToBezier(p, [1], p, p)).toThrow(/^m0: expected 2 coordinates/);
    expect(() => hermiteToBezier([], p, p, p)).toThrow("p0: expected at least one coordinate, got []");
    expect(() => bezierToHermite([p, p, p])).toThrow("controlPoints: expected at least 4 points, got 3");
    expect(() => bezierToHermite([p, p, p, p, p])).toThrow("controlPoints: expected 4 points, got 5");
  });
});

describe("K and its inverse", () => {
  const interval = fc.tuple(
    fc.double({ min: -3, max: 3, noNaN: true }),
    fc.double({ min: 0.2, max: 4, noNaN: true }),
    fc.boolean(),
  );

  test("K⁻¹·K is the identity, on any interval, backwards too", () => {
    forAll([interval], ([a, h, back]) => {
      const { K, Kinv } = back ? hermiteMatrix(a + h, a) : hermiteMatrix(a, a + h);
      const size = Math.max(...Kinv.flat().map(Math.abs)) * Math.max(...K.flat().map(Math.abs));
      multiply4(K, Kinv).forEach((row, i) => {
        row.forEach((entry, j) => {
          expect(Math.abs(entry - identity4[i]![j]!)).toBeLessThan(1e-14 * size);
        });
      });
    });
  });

  test("agrees with elimination", () => {
    const { K, Kinv } = hermiteMatrix(2, 4);
    invert4(K)!.forEach((row, i) => {
      row.forEach((entry, j) => {
        expect(entry).toBeCloseTo(Kinv[i]![j]!, 8);
      });
    });
  });

  test("K⁻¹·G meets points and tangents on [t_r, t_{r+1}]", () => {
    forAll([interval, geometry], ([a, h], [p0, p1, m0, m1]) => {
      const C = hermiteCoefficientMatrix(a, a + h, [p0, p1, m0, m1]);
      const at = (t: number, r: number) =>
        combine(r === 0 ? [t ** 3, t ** 2, t, 1] : [3 * t ** 2, 2 * t, 1, 0], C);
      const tolerance = (1e-9 * size([p0, p1, m0, m1])) / h ** 3;
      expect(distance(at(a, 0), p0)).toBeLessThan(tolerance);
      expect(distance(at(a + h, 0), p1)).toBeLessThan(tolerance);
      expect(distance(at(a, 1), m0)).toBeLessThan(tolerance);
      expect(distance(at(a + h, 1), m1)).toBeLessThan(tolerance);
    });
  });

  test("bad arguments are named", () => {
    expect(() => hermiteMatrix(1, 1)).toThrow("tr1: expected a number clearly different from tr = 1, got 1");
    expect(() => hermiteMatrix(0, 1e-120)).toThrow(/^tr1: expected a number clearly different/);
    expect(() => hermiteMatrix(Number.NaN, 1)).toThrow("tr: expected a finite number, got NaN");
    expect(() => hermiteMatrix(0, Number.NaN)).toThrow("tr1: expected a finite number, got NaN");
    expect(() => hermiteCoefficientMatrix(0, 1, [[1], [2], [3]])).toThrow(
      /^geometry: expected at least 4 points/,
    );
    expect(() => hermiteCoefficientMatrix(0, 1, [[1], [2], [3], [4], [5]])).toThrow(
      "geometry: expected 4 points, got 5",
    );
  });
});

describe("order m", () => {
  const order = fc.integer({ min: 0, max: 5 });

  test("δ-condition: derivative r of H_{i,k} at end j is δ_ij·δ_kr", () => {
    for (const [t0, t1] of [
      [0, 1],
      [2, 5],
      [-1, -0.5],
    ] as const) {
      for (let m = 0; m <= 5; m++) {
        for (let r = 0; r <= m; r++) {
          [t0, t1].forEach((t, j) => {
            const values = hermiteBasis(m, t0, t1, t, r);
            const wanted = [0, 1].map((i) => values[0].map((_, k) => (i === j && k === r ? 1 : 0)));
            const scale = 1e-13 * 20 ** r * Math.max(1, (t1 - t0) ** -r);
            expect(distance(values.flat(), wanted.flat())).toBeLessThan(scale);
          });
        }
      }
    }
  });

  test("the exact coefficients give the same polynomials", () => {
    for (let m = 0; m <= 6; m++) {
      const basis = hermiteBasisCoefficients(m);
      const order = Array.from({ length: m + 1 }, (_, k) => k);
      expect(basis.map(({ i, k }) => [i, k])).toEqual([0, 1].flatMap((i) => order.map((k) => [i, k])));
      for (const { coefficients, numerators, denominator } of basis) {
        expect(coefficients.length).toBe(2 * m + 2);
        expect(numerators.map((c) => c / denominator)).toEqual(coefficients);
        expect(numerators.every(Number.isSafeInteger)).toBe(true);
      }
      for (const t of [0, 0.1, 0.25, 0.5, 0.8, 1]) {
        const row = powers(t, 2 * m + 2);
        const sums = basis.map(
          ({ coefficients }) =>
            combine(
              row,
              coefficients.map((c) => [c]),
            )[0]!,
        );
        expect(distance(sums, hermiteBasis(m, 0, 1, t).flat())).toBeLessThan(1e-11);
      }
    }
  });

  test("numerators and denominator have no common factor", () => {
    const gcd = (a: number, b: number): number => (b === 0 ? Math.abs(a) : gcd(b, a % b));
    for (let m = 0; m <= 6; m++) {
      for (const { numerators, denominator } of hermiteBasisCoefficients(m)) {
        expect(numerators.reduce(gcd, denominator)).toBe(1);
        expect(denominator).toBeGreaterThan(0);
      }
    }
  });

  test("the curve has the given derivatives at both ends, and those alone fix it", () => {
    const problem = order.chain((m) =>
      fc.tuple(
        fc.array(point(2), { minLength: m + 1, maxLength: m + 1 }),
        fc.array(point(2), { minLength: m + 1, maxLength: m + 1 }),
        fc.double({ min: -2, max: 2, noNaN: true }),
        fc.double({ min: 0.5, max: 3, noNaN: true }),
      ),
    );
    forAll([problem], ([start, end, t0, h]) => {
      const curve = hermiteCurve(t0, t0 + h, start, end);
      const length = curve.domain[1] - curve.domain[0];
      start.forEach((vector, r) => {
        const tolerance =
          1e-10 * size([...start, ...end]) * 30 ** r * Math.max(1, length, 1 / length) ** (2 * r + 1) * 10;
        expect(distance(curve.derivative(t0, r), vector)).toBeLessThan(tolerance);
        expect(distance(curve.derivative(t0 + h, r), end[r]!)).toBeLessThan(tolerance);
      });
      expect(curve.dimension).toBe(2);
      expect(curve.derivative(t0, 2 * start.length)).toEqual([0, 0]);
    });
  });

  test("order 1 on [0, 1] is the cubic segment; the basis curve lists all polynomials", () => {
    forAll([unit], (t) => {
      const [h0, h1, h2, h3] = hermiteCubicBasis(t);
      const [[a, b], [c, d]] = hermiteBasis(1, 0, 1, t) as [[number, number], [number, number]];
      expect(distance([a, b, c, d], [h0, h1, h3, h2])).toBeLessThan(1e-14);
      expect(hermiteBasisCurve(1, 0, 1).point(t)).toEqual([a, b, c, d]);
    });
    expect(hermiteBasisCoefficients(1).map(({ coefficients }) => coefficients)).toEqual([
      [1, 0, -3, 2],
      [0, 1, -2, 1],
      [0, 0, 3, -2],
      [0, 0, -1, 1],
    ]);
  });

  test("bad arguments are named", () => {
    expect(() => hermiteBasisCoefficients(-1)).toThrow(/^m: /);
    expect(() => hermiteBasis(0.5, 0, 1, 0)).toThrow(/^m: /);
    expect(() => hermiteBasis(1, 0, 1, Number.NaN)).toThrow(/^t: /);
    expect(() => hermiteBasis(1, 0, 1, 0, -1)).toThrow(/^r: /);
    expect(() => hermiteCurve(1, 1, [[0]], [[1]])).toThrow(
      "t1: expected a number greater than t0 = 1, got 1",
    );
    expect(() => hermiteCurve(0, 1, [], [])).toThrow(/^start: /);
    expect(() => hermiteCurve(0, 1, [[0]], [[1, 2]])).toThrow("end[0]: expected 1 coordinate, got [1, 2]");
    expect(() => hermiteCurve(0, 1, [[0], [1]], [[1]])).toThrow(
      "end: expected 2 entries, one for each of start, got 1",
    );
  });
});
