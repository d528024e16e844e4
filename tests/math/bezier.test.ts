import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  add,
  bernsteinAll,
  bezierDerivative,
  bezierPoint,
  combine,
  convexHull,
  cross2,
  deCasteljau,
  distance,
  hodograph,
  type Point,
  scale,
  sub,
} from "../../src/math/index.ts";
import { forAll, point, points, size, unit } from "./property.ts";

const cubic: Point[] = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];
const curve = points(1, 9);

describe("deCasteljau", () => {
  test("returns every level, from the control points to the curve point", () => {
    expect(deCasteljau(cubic, 0.5)).toEqual([
      cubic,
      [
        [0.5, 1],
        [2, 2],
        [3.5, 1],
      ],
      [
        [1.25, 1.5],
        [2.75, 1.5],
      ],
      [[2, 1.5]],
    ]);
    expect(deCasteljau([[7]], 0.3)).toEqual([[[7]]]);
  });

  test("the caller's list is neither changed nor handed out", () => {
    const levels = deCasteljau(cubic, 0.25);
    expect(levels[0]).toEqual(cubic);
    expect(levels[0]).not.toBe(cubic);
  });

  test("gives Σ b_i B_i^n(t)", () => {
    forAll([curve, unit], (b, t) => {
      const sum = combine(bernsteinAll(b.length - 1, t), b);
      expect(distance(bezierPoint(b, t), sum)).toBeLessThan(1e-13 * size(b));
    });
  });
});

describe("bezierPoint", () => {
  test("starts and ends in the end control points, exactly", () => {
    forAll([curve], (b) => {
      expect(distance(bezierPoint(b, 0), b[0]!)).toBe(0);
      expect(distance(bezierPoint(b, 1), b.at(-1)!)).toBe(0);
    });
  });

  test("is invariant under affine maps", () => {
    const map = fc.tuple(point(2), point(2), point(2));
    forAll([points(1, 8, 2), map, unit], (b, [column1, column2, shift], t) => {
      const image = (p: Point) => add(add(scale(column1, p[0]!), scale(column2, p[1]!)), shift);
      const mapped = b.map(image);
      const bound = 1e-12 * (1 + size(b) * size([column1, column2]) + size([shift]));
      expect(distance(bezierPoint(mapped, t), image(bezierPoint(b, t)))).toBeLessThan(bound);
    });
  });

  test("lies in the convex hull of the control points", () => {
    forAll([points(3, 8, 2), unit], (b, t) => {
      const hull = convexHull(b);
      fc.pre(hull.length > 2);
      const p = bezierPoint(b, t);
      hull.forEach((vertex, i) => {
        const edge = sub(hull[(i + 1) % hull.length]!, vertex);
        expect(cross2(edge, sub(p, vertex))).toBeGreaterThan(-1e-9 * size(b) ** 2);
      });
    });
  });

  test("runs backwards with reversed control points", () => {
    forAll([curve, unit], (b, t) => {
      const reversed = [...b].reverse();
      expect(distance(bezierPoint(reversed, 1 - t), bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
    });
  });

  test("continues the polynomial outside [0, 1]", () => {
    expect(bezierPoint([[0], [0], [1]], 3)).toEqual([9]);
    expect(bezierPoint(cubic, -1)).toEqual([2, -12]);
  });

  test("overflows neither for huge coordinates nor at a degree of 200", () => {
    expect(bezierPoint([[1e308], [-1e308], [1e308]], 0.5)).toEqual([0]);
    const many = Array.from({ length: 201 }, (_, i) => [i / 200]);
    expect(bezierPoint(many, 0.3)[0]).toBeCloseTo(0.3, 12);
  });
});

describe("hodograph and derivative", () => {
  test("end derivatives are n times the end legs", () => {
    expect(hodograph(cubic)).toEqual([
      [3, 6],
      [6, 0],
      [3, -6],
    ]);
    expect(bezierDerivative(cubic, 0)).toEqual([3, 6]);
    expect(bezierDerivative(cubic, 1)).toEqual([3, -6]);
    expect(bezierDerivative(cubic, 0, 2)).toEqual([6, -12]);
    expect(bezierDerivative(cubic, 0.7, 3)).toEqual([-12, 0]);
  });

  test("order 0 is the curve, an order above the degree the zero vector", () => {
    expect(hodograph(cubic, 0)).toEqual(cubic);
    expect(bezierDerivative(cubic, 0.5, 0)).toEqual([2, 1.5]);
    expect(hodograph(cubic, 4)).toEqual([[0, 0]]);
    expect(hodograph([[1, 2, 3]])).toEqual([[0, 0, 0]]);
    expect(bezierDerivative(cubic, 0.5, 9)).toEqual([0, 0]);
  });

  test("agrees with the difference quotient", () => {
    const h = 1e-5;
    forAll([points(1, 7), unit, fc.integer({ min: 0, max: 3 })], (b, t, r) => {
      const ahead = bezierDerivative(b, t + h, r);
      const behind = bezierDerivative(b, t - h, r);
      const quotient = scale(sub(ahead, behind), 1 / (2 * h));
      expect(distance(bezierDerivative(b, t, r + 1), quotient)).toBeLessThan(1e-3 * size(b));
    });
  });

  test("does not depend on where the origin is", () => {
    forAll([points(2, 7, 3), point(3), unit], (b, shift, t) => {
      const moved = b.map((p) => add(p, shift));
      const bound = 1e-11 * (size(b) + size([shift]));
      expect(distance(bezierDerivative(moved, t), bezierDerivative(b, t))).toBeLessThan(bound);
    });
  });
});

test("bad data are named", () => {
  for (const call of [
    (b: Point[]) => bezierPoint(b, 0.5),
    (b: Point[]) => bezierDerivative(b, 0.5),
    (b: Point[]) => deCasteljau(b, 0.5),
    (b: Point[]) => hodograph(b),
  ]) {
    expect(() => call([])).toThrow("controlPoints: expected at least 1 point, got none");
    expect(() => call([[1, 2], [3]])).toThrow("controlPoints[1]: expected 2 coordinates, got [3]");
    expect(() =>
      call([
        [1, 2],
        [3, Number.NaN],
      ]),
    ).toThrow("controlPoints[1][1]: expected a finite number, got NaN");
    expect(() => call([[]])).toThrow(RangeError);
  }
  expect(() => bezierPoint(cubic, Number.NaN)).toThrow("t: expected a finite number, got NaN");
  expect(() => hodograph(cubic, -1)).toThrow("r: expected a whole number of at least 0, got -1");
  expect(() => bezierDerivative(cubic, 0, 0.5)).toThrow(/^r: /);
});
