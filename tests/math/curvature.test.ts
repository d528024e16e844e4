import fc from "fast-check";
import { expect, test } from "vitest";
import {
  bezierCurve,
  curvature,
  curvatureVector,
  curvatureVectorOf,
  dot,
  norm,
  type Point,
  rationalBezierCurve,
  scale,
  torsion,
} from "../../src/math/index.ts";
import { forAll, points, unit } from "./property.ts";

const quarter = rationalBezierCurve(
  [
    [3, 0],
    [3, 3],
    [0, 3],
  ],
  [1, Math.SQRT1_2, 1],
);

test("the circle of radius 3 turned to the left has curvature 1/3, reversed −1/3", () => {
  const back = rationalBezierCurve(
    [
      [0, 3],
      [3, 3],
      [3, 0],
    ],
    [1, Math.SQRT1_2, 1],
  );
  forAll([unit], (t) => {
    expect(curvature(quarter, t)).toBeCloseTo(1 / 3, 12);
    expect(curvature(back, t)).toBeCloseTo(-1 / 3, 12);
    const centre = curvatureVector(quarter, t)!.map((x, axis) => quarter.point(t)[axis]! + 9 * x);
    expect(norm(centre)).toBeLessThan(1e-12);
  });
});

test("a plane curve in space has a curvature ≥ 0; one dimension has none", () => {
  const inSpace = bezierCurve([
    [0, 0, 1],
    [1, 3, 1],
    [4, 3, 1],
    [5, 0, 1],
  ]);
  const inPlane = bezierCurve([
    [0, 0],
    [1, 3],
    [4, 3],
    [5, 0],
  ]);
  expect(curvature(inPlane, 0.5)).toBeCloseTo(-0.5, 14);
  expect(curvature(inSpace, 0.5)).toBeCloseTo(0.5, 14);
  expect(torsion(inSpace, 0.3)).toBeCloseTo(0, 14);
  expect(curvature(bezierCurve([[0], [1], [5]]), 0.5)).toBe(0);
});

test("the curvature vector is across the tangent and as long as the curvature", () => {
  forAll([points(3, 6, 3), unit], (b, t) => {
    const curve = bezierCurve(b);
    const vector = curvatureVector(curve, t);
    const value = curvature(curve, t);
    if (vector === null || value === null) {
      expect([vector, value]).toEqual([null, null]);
      return;
    }
    const velocity = curve.derivative(t);
    const bend = norm(curve.derivative(t, 2)) / norm(velocity) ** 2;
    expect(Math.abs(dot(vector, velocity))).toBeLessThan(1e-9 * (1 + bend) * norm(velocity));
    expect(Math.abs(norm(vector) - value)).toBeLessThan(1e-9 * (1 + bend));
  });
  expect(curvatureVectorOf([2, 0], [7, 8])).toEqual([0, 2]);
});

test("does not depend on the parametrisation, and scales as 1 / length", () => {
  const factor = fc.double({ min: 0.1, max: 10, noNaN: true });
  forAll([factor, factor, unit], (stretch, size, t) => {
    const b: Point[] = [
      [0, 0, 0],
      [1, 2, 0],
      [3, 2, 1],
      [4, 0, 3],
    ];
    const curve = bezierCurve(b);
    const other = bezierCurve(
      b.map((p) => scale(p, size)),
      [0, stretch],
    );
    expect(curvature(other, stretch * t)! * size).toBeCloseTo(curvature(curve, t)!, 10);
    expect(torsion(other, stretch * t)! * size).toBeCloseTo(torsion(curve, t)!, 10);
  });
});

test("the torsion of a twisted cubic (t, t², t³): 3 / (1 + 9t² + 9t⁴)", () => {
  const twisted = bezierCurve([
    [0, 0, 0],
    [1 / 3, 0, 0],
    [2 / 3, 1 / 3, 0],
    [1, 1, 1],
  ]);
  for (const t of [0, 0.3, 1]) {
    expect(torsion(twisted, t)).toBeCloseTo(3 / (1 + 9 * t ** 2 + 9 * t ** 4), 12);
  }
});

test("null up to rounding, at every size and over every domain", () => {
  for (const size of [1e-6, 1, 1e6]) {
    for (const domain of [
      [0, 1],
      [1000, 1001],
      [0, 1e-3],
    ] as const) {
      const place = (b: readonly Point[]) =>
        bezierCurve(
          b.map((p) => p.map((x) => size * (0.1 + 0.3 * x))),
          domain,
        );
      const middle = (domain[0] + domain[1]) / 2;
      const cusp = place([
        [0, 0, 0],
        [2, 2, 0],
        [0, 2, 0],
        [2, 0, 0],
      ]);
      expect([curvature(cusp, middle), torsion(cusp, middle)]).toEqual([null, null]);
      expect(
        torsion(
          place([
            [0, 0, 0],
            [1, 2, 3],
            [2, 4, 6],
            [3, 6, 9],
          ]),
          middle,
        ),
      ).toBeNull();
      // A bend of 1e-6 of the length is a bend.
      const faint = place([
        [0, 0, 0],
        [1, 0, 0],
        [2, 1e-6, 0],
        [3, 3e-6, 1e-6],
      ]);
      expect(torsion(faint, domain[0])).not.toBeNull();
    }
  }
});

test("null where there is none", () => {
  const cusp = bezierCurve([
    [0, 0],
    [2, 2],
    [0, 2],
    [2, 0],
  ]);
  expect([curvature(cusp, 0.5), curvatureVector(cusp, 0.5)]).toEqual([null, null]);
  expect(curvature(bezierCurve([[1, 1]]), 0)).toBeNull();
  const line = bezierCurve([
    [0, 0, 0],
    [0.1, 0.1, 0.1],
    [0.2, 0.2, 0.2],
    [0.3, 0.3, 0.3],
  ]);
  expect(curvature(line, 0.3)).toBeCloseTo(0, 12);
  expect(torsion(line, 0.3)).toBeNull();
  expect(
    torsion(
      bezierCurve([
        [0, 0, 0],
        [0, 0, 0],
        [1, 2, 3],
        [4, 5, 6],
      ]),
      0,
    ),
  ).toBeNull();
  expect(
    torsion(
      bezierCurve([
        [0, 0, 0],
        [1, 0, 0],
        [2, 0, 0],
        [3, 1, 1],
      ]),
      0,
    ),
  ).toBeNull();
  expect(() => torsion(cusp, 0.1)).toThrow("curve: expected a curve in 3 dimensions, got 2");
});
