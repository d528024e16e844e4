import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  applyToGeometry,
  type BasisName,
  basisMatrix,
  basisNames,
  bernsteinAll,
  bezierPoint,
  blendingFunctions,
  bsplineBasis,
  catmullRomSegment,
  conversionMatrix,
  convertBasis,
  distance,
  exactBasisMatrix,
  hermiteCubicBasis,
  hermiteCubicBasisPointsFirst,
  identity4,
  invert4,
  type Matrix4,
  matrixPoint,
  multiply4,
  type Point,
  powers4,
  rowTimes4,
} from "../../src/math/index.ts";
import { coordinate, forAll, point, size, unit } from "./property.ts";

const name = fc.constantFrom(...basisNames);
const geometry = fc.array(point(2), { minLength: 4, maxLength: 4 });
const row = fc.tuple(coordinate, coordinate, coordinate, coordinate);
const matrix: fc.Arbitrary<Matrix4> = fc.tuple(row, row, row, row);
const worst = (a: Matrix4, b: Matrix4) => Math.max(...a.flat().map((x, i) => Math.abs(x - b.flat()[i]!)));

describe("4×4 matrices", () => {
  test("products: by hand and associative", () => {
    const a: Matrix4 = [
      [1, 2, 0, 0],
      [0, 1, 3, 0],
      [4, 0, 1, 0],
      [0, 0, 5, 1],
    ];
    expect(multiply4(a, identity4)).toEqual(a);
    expect(multiply4(identity4, a)).toEqual(a);
    expect(rowTimes4([1, 1, 1, 2], a)).toEqual([5, 3, 14, 2]);
    expect(applyToGeometry(a, [[1], [10], [100], [1000]])).toEqual([[21], [310], [104], [1500]]);
    expect(multiply4(a, a)[0]).toEqual([1, 4, 6, 0]);
  });

  test("M⁻¹·M and M·M⁻¹ are the identity", () => {
    forAll([matrix], (m) => {
      const inverse = invert4(m);
      fc.pre(inverse !== null);
      const condition = Math.max(...m.flat().map(Math.abs)) * Math.max(...inverse!.flat().map(Math.abs));
      fc.pre(condition < 1e8);
      expect(worst(multiply4(inverse!, m), identity4)).toBeLessThan(1e-13 * condition * condition);
      expect(worst(multiply4(m, inverse!), identity4)).toBeLessThan(1e-13 * condition * condition);
    });
  });

  test("needs row exchanges, knows no unit, finds singular ones", () => {
    const turned: Matrix4 = [
      [0, 0, 0, 1],
      [0, 0, 1e-40, 0],
      [0, 1e40, 0, 0],
      [2, 0, 0, 0],
    ];
    expect(
      invert4(turned)!
        .flat()
        .filter((x) => x !== 0),
    ).toEqual([0.5, 1e-40, 1e40, 1].map((x) => expect.closeTo(x, 10)));
    expect(invert4([identity4[0], identity4[1], identity4[2], [0, 0, 0, 0]])).toBeNull();
    expect(invert4([identity4[0], identity4[1], [1, 1, 0, 0], identity4[3]])).toBeNull();
    expect(invert4([[0.1, 0.2, 0.3, 0.4], [0.3, 0.6, 0.9, 1.2], identity4[2], identity4[3]])).toBeNull();
    expect(
      invert4([
        [1, 0, 0, 0],
        [0, 1, 0, 0],
        [0, 0, 1, 0],
        [1, 0, 0, 1e-9],
      ]),
    ).not.toBeNull();
    const bad = [identity4[0], identity4[1], [0, 0, Number.NaN, 0], identity4[3]] as unknown as Matrix4;
    expect(() => invert4(bad)).toThrow("matrix[2][2]: expected a finite number, got NaN");
  });
});

describe("basis matrices", () => {
  test("hold the named bases", () => {
    const knots = [-3, -2, -1, 0, 1, 2, 3, 4];
    const unitPoints = identity4 as unknown as Point[];
    forAll([unit], (t) => {
      const near = (basis: BasisName, wanted: readonly number[]) =>
        expect(distance(blendingFunctions(basisMatrix(basis), t), wanted)).toBeLessThan(1e-14);
      near("monomial", [t ** 3, t ** 2, t, 1]);
      near("hermite", hermiteCubicBasis(t));
      near("hermitePointsFirst", hermiteCubicBasisPointsFirst(t));
      near("bezier", bernsteinAll(3, t));
      near("catmullRom", catmullRomSegment(unitPoints, 0).point(t));
      near("bspline", bsplineBasis(3, knots, t));
    });
  });

  test("the exact form is whole numbers over one denominator", () => {
    for (const basis of basisNames) {
      const { numerators, denominator } = exactBasisMatrix(basis);
      expect(numerators.flat().every(Number.isInteger)).toBe(true);
      expect(numerators.map((r) => r.map((x) => x / denominator))).toEqual(basisMatrix(basis));
    }
    expect(() => basisMatrix("lagrange" as BasisName)).toThrow(
      'basis: expected one of monomial, hermite, hermitePointsFirst, bezier, catmullRom, bspline, got "lagrange"',
    );
  });

  test("powers and their derivatives", () => {
    expect([0, 1, 2, 3, 4].map((r) => powers4(2, r))).toEqual([
      [8, 4, 2, 1],
      [12, 4, 1, 0],
      [12, 2, 0, 0],
      [6, 0, 0, 0],
      [0, 0, 0, 0],
    ]);
  });

  test("U·M·G is the curve, its derivative the tangent", () => {
    forAll([geometry, unit], (g, t) => {
      expect(distance(matrixPoint(basisMatrix("bezier"), g, t), bezierPoint(g, t))).toBeLessThan(
        1e-13 * size(g),
      );
    });
    expect(matrixPoint(basisMatrix("hermite"), [[1], [2], [3], [4]], 0, 1)).toEqual([2]);
    expect(matrixPoint(basisMatrix("hermite"), [[1], [2], [3], [4]], 1, 1)).toEqual([3]);
    expect(() => matrixPoint(identity4, [[1], [2], [3]], 0)).toThrow(
      "geometry: expected at least 4 points, got 3",
    );
    expect(() => matrixPoint(identity4, [[1], [2], [3], [4], [5]], 0)).toThrow(
      "geometry: expected 4 points, got 5",
    );
  });
});

describe("basis change", () => {
  test("the curve stays, from any basis to any other", () => {
    forAll([geometry, name, name, unit], (g, from, to, t) => {
      const converted = convertBasis(g, from, to)!;
      const before = matrixPoint(basisMatrix(from), g, t);
      const after = matrixPoint(basisMatrix(to), converted, t);
      expect(distance(before, after)).toBeLessThan(1e-12 * size(g) * size(converted));
    });
  });

  test("own matrices are as good as names; a singular one is no basis", () => {
    const own: Matrix4 = [
      [1, 0, 0, 0],
      [0, 2, 0, 0],
      [0, 0, 4, 0],
      [0, 0, 0, 8],
    ];
    expect(conversionMatrix("monomial", own)).toEqual([
      [1, 0, 0, 0],
      [0, 0.5, 0, 0],
      [0, 0, 0.25, 0],
      [0, 0, 0, 0.125],
    ]);
    expect(conversionMatrix(own, "monomial")).toEqual(own);
    const singular = [own[0], own[0], own[2], own[3]] as const;
    expect(conversionMatrix("bezier", singular)).toBeNull();
    expect(convertBasis([[0], [1], [2], [3]], "bezier", singular)).toBeNull();
    expect(conversionMatrix(singular, "monomial")).toEqual(singular);
  });

  test("bad arguments are named", () => {
    expect(() => convertBasis([[0]], "bezier", "hermite")).toThrow(/^geometry: /);
    expect(() => conversionMatrix("x" as BasisName, "hermite")).toThrow(/^basis: /);
  });
});
