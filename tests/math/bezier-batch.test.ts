import fc from "fast-check";
import { expect, test } from "vitest";
import {
  bezierDerivative,
  bezierDerivativeInto,
  bezierPoint,
  bezierPointInto,
  bezierPointsInto,
  bezierPolylineInto,
  distance,
  fromFlat,
  type Point,
  toFlat,
} from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const cubic: Point[] = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];
const curve = points(1, 9);

test("flat coordinates and back", () => {
  expect(toFlat(cubic)).toEqual(new Float64Array([0, 0, 1, 2, 3, 2, 4, 0]));
  expect(toFlat([])).toEqual(new Float64Array(0));
  forAll([curve], (b) => {
    expect(fromFlat(toFlat(b), b[0]!.length)).toEqual(b);
  });
});

test("points agree with de Casteljau's construction, and end exactly", () => {
  forAll([curve, unit], (b, t) => {
    const dimension = b[0]!.length;
    const out = new Float64Array(dimension + 2).fill(-7);
    bezierPointInto(out, toFlat(b), dimension, t, 1);
    expect(distance([...out].slice(1, -1), bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
    expect([out[0], out.at(-1)]).toEqual([-7, -7]);
    for (const [end, point] of [
      [0, b[0]!],
      [1, b.at(-1)!],
    ] as const) {
      bezierPointInto(out, toFlat(b), dimension, end);
      expect(distance([...out].slice(0, dimension), point)).toBe(0);
    }
  });
});

test("cubics, the case with formulas of its own, in every dimension", () => {
  for (const dimension of [1, 2, 3, 4]) {
    forAll([points(4, 4, dimension), unit], (b, t) => {
      const out = new Float64Array(dimension);
      bezierPointInto(out, toFlat(b), dimension, t);
      expect(distance([...out], bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
      bezierPointsInto(out, toFlat(b), dimension, [t]);
      expect(distance([...out], bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
    });
  }
});

test("nothing is written beside the points", () => {
  for (const b of [
    cubic,
    [
      [0, 0],
      [2, 2],
    ],
  ]) {
    const out = new Float64Array(7).fill(-7);
    bezierPointsInto(out, toFlat(b), 2, [0.1, 0.2]);
    expect([...out].slice(4)).toEqual([-7, -7, -7]);
  }
});

test("derivatives agree too", () => {
  forAll([curve, unit], (b, t) => {
    const dimension = b[0]!.length;
    const out = new Array<number>(dimension + 1).fill(9);
    bezierDerivativeInto(out, toFlat(b), dimension, t, 1);
    expect(distance(out.slice(1), bezierDerivative(b, t))).toBeLessThan(1e-11 * size(b));
    expect(out[0]).toBe(9);
  });
});

test("many points at once, in the plane and elsewhere", () => {
  const ts = fc.array(unit, { minLength: 0, maxLength: 5 });
  const plane = points(4, 4, 2);
  forAll([fc.oneof(curve, plane), ts], (b, list) => {
    const dimension = b[0]!.length;
    const out = new Float64Array(list.length * dimension);
    bezierPointsInto(out, toFlat(b), dimension, list);
    const found = fromFlat(out, dimension);
    list.forEach((t, k) => {
      expect(distance(found[k]!, bezierPoint(b, t))).toBeLessThan(1e-12 * size(b));
    });
  });
  // Eight coordinates that are no plane cubic: a line in four dimensions.
  const line = new Float64Array([0, 0, 0, 0, 1, 2, 3, 4]);
  const out = new Float64Array(4);
  bezierPointsInto(out, line, 4, [0.5]);
  expect([...out]).toEqual([0.5, 1, 1.5, 2]);
});

test("a polyline over equal steps", () => {
  const out = new Float64Array(10);
  bezierPolylineInto(out, toFlat(cubic), 2, 4);
  expect(fromFlat(out, 2)).toEqual([0, 0.25, 0.5, 0.75, 1].map((t) => bezierPoint(cubic, t)));
});

test("high degrees neither overflow nor lose digits", () => {
  for (const n of [60, 61, 1500]) {
    const line = Array.from({ length: n + 1 }, (_, i) => [i / n, 1]);
    const out = [9, 9, 9];
    for (const t of [0, 0.3, 0.9, 1]) {
      bezierPointInto(out, toFlat(line), 2, t);
      expect(out[0]).toBeCloseTo(t, 11);
      expect(out[1]).toBeCloseTo(1, 11);
      expect(out[2]).toBe(9);
    }
  }
});
