import { expect, test } from "vitest";
import { bezierCurve, bezierInflections, curvature, type Point } from "../../src/math/index.ts";
import { forAll, points } from "./property.ts";

test("one in an S, none in an arch, a straight line, a cubic's cusp and a parabola", () => {
  const none: Point[][] = [
    [
      [0, 0],
      [1, 3],
      [4, 3],
      [5, 0],
    ],
    [
      [0, 0],
      [1, 1],
      [2, 2],
      [3, 3],
    ],
    [
      [0.1, 0.1],
      [0.2, 0.2],
      [0.3, 0.3],
      [0.7, 0.7],
      [0.4, 0.4],
    ],
    [
      [0, 0],
      [2, 2],
      [0, 2],
      [2, 0],
    ],
    [
      [0, 0],
      [1, 2],
      [3, 0],
    ],
    [
      [0, 0],
      [1, 2],
    ],
    [[1, 1]],
  ];
  none.push(Array.from({ length: 5 }, (_, i) => [1000.1 + 0.1 * i * i, 500.7 + 0.3 * i * i]));
  for (const curve of none) expect(bezierInflections(curve)).toEqual([]);
  expect(
    bezierInflections([
      [0, 0],
      [1, 4],
      [3, -4],
      [4, 0],
    ]),
  ).toEqual([0.5]);
  const wave: Point[] = [
    [0, 0],
    [1, 3],
    [2, -3],
    [3, 3],
    [4, -3],
    [5, 0],
  ];
  const found = bezierInflections(wave);
  expect(found).toHaveLength(3);
  expect(found[0]).toBeCloseTo(0.5 - Math.sqrt(0.05), 12);
  expect(found[1]).toBeCloseTo(0.5, 12);
});

test("a faint S has its inflection and a straight curve has none, at every size and far from the origin", () => {
  for (const size of [1e-6, 1, 1e6]) {
    for (const shift of [0, 300]) {
      const place = (b: Point[]): Point[] => b.map((p) => p.map((x) => size * (x + shift)));
      const faint = bezierInflections(
        place([
          [0, 0],
          [1, 1e-5],
          [3, -1e-5],
          [4, 0],
        ]),
      );
      expect(faint).toHaveLength(1);
      expect(faint[0]).toBeCloseTo(0.5, 5);
      const line = place([0, 1, 3, 3.5, 7].map((x) => [0.1 * x, 0.3 * x]));
      expect(bezierInflections(line)).toEqual([]);
      expect(bezierInflections(place([0, 1, 2, 3].map((x) => [0.1 * x, 0.3 * x])))).toEqual([]);
    }
  }
});

test("a repeated control point does not make a bent curve straight", () => {
  expect(
    bezierInflections([
      [0, 0],
      [0, 0],
      [1, 2],
      [3, -2],
      [4, 0],
      [4, 0],
    ]),
  ).toHaveLength(1);
});

test("the curvature vanishes there and turns to the other side", () => {
  forAll([points(4, 6, 2)], (b) => {
    const curve = bezierCurve(b);
    const inflections = bezierInflections(b);
    const stops = [0, ...inflections, 1];
    for (const [i, t] of inflections.entries()) {
      const [before, after] = [stops[i]!, stops[i + 2]!];
      if (t - before < 1e-3 || after - t < 1e-3) continue;
      const left = curvature(curve, t - 1e-4);
      const right = curvature(curve, t + 1e-4);
      const here = curvature(curve, t);
      if (left === null || right === null || here === null) continue;
      if (Math.abs(left) < 1e-6 || Math.abs(right) < 1e-6) continue;
      expect(Math.sign(left)).toBe(-Math.sign(right));
      expect(Math.abs(here)).toBeLessThan(1e-3 * (Math.abs(left) + Math.abs(right)));
    }
  });
});

test("bad control points are named", () => {
  expect(() => bezierInflections([[1, 2, 3]])).toThrow(/^controlPoints\[0\]: expected 2 coordinates/);
  expect(() => bezierInflections([])).toThrow(/^controlPoints: /);
});
