import fc from "fast-check";
import { expect, test } from "vitest";
import { convexHull, cross2, distance, type Point, sub } from "../../src/math/index.ts";
import { forAll, points, size } from "./property.ts";

test("counter-clockwise from the lowest of the leftmost points, without inner and edge points", () => {
  expect(
    convexHull([
      [2, 4],
      [1, 1],
      [4, 0],
      [0, 0],
    ]),
  ).toEqual([
    [0, 0],
    [4, 0],
    [2, 4],
  ]);
  expect(
    convexHull([
      [0, 2],
      [0, 0],
      [1, 0],
      [2, 0],
      [2, 2],
      [0, 1],
      [1, 1],
      [0, 0],
    ]),
  ).toEqual([
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
  ]);
});

test("degenerate point sets", () => {
  expect(
    convexHull([
      [3, 1],
      [3, 1],
      [3, 1],
    ]),
  ).toEqual([[3, 1]]);
  expect(
    convexHull([
      [3, 3],
      [1, 1],
      [0, 0],
      [2, 2],
    ]),
  ).toEqual([
    [0, 0],
    [3, 3],
  ]);
  expect(
    convexHull([
      [1, 5],
      [1, 2],
      [1, 3],
    ]),
  ).toEqual([
    [1, 2],
    [1, 5],
  ]);
  expect(
    convexHull([
      [0.1, 0.1],
      [0.2, 0.2],
      [0.3, 0.3],
      [0.7, 0.7],
    ]),
  ).toEqual([
    [0.1, 0.1],
    [0.7, 0.7],
  ]);
});

test("collinear up to the rounding of decimals, far from the origin", () => {
  const line = Array.from({ length: 9 }, (_, i): Point => [1000.1 + 0.1 * i, 500.7 + 0.3 * i]);
  expect(convexHull(line)).toEqual([line[0], line[8]]);
});

test("a corner of one part in a million is one, at every size; one of 1e-12 is not", () => {
  for (const size of [1e-6, 1, 1e6]) {
    const place = (list: Point[]): Point[] => list.map((p) => p.map((x) => size * x));
    const corner = place([
      [0, 0],
      [0.1, -1e-6],
      [5, 0],
      [2, 3],
    ]);
    expect(convexHull(corner)).toEqual(corner);
    const straight = place([
      [0, 0],
      [0.1, -1e-13],
      [5, 0],
      [2, 3],
    ]);
    expect(convexHull(straight)).toHaveLength(3);
  }
  const square = [
    [1e9, 1e9],
    [1e9 + 1e-3, 1e9],
    [1e9 + 1e-3, 1e9 + 1e-3],
    [1e9, 1e9 + 1e-3],
  ];
  expect(convexHull(square)).toHaveLength(4);
});

test("the caller's list keeps its order", () => {
  const list: Point[] = [
    [2, 0],
    [0, 0],
    [1, 1],
  ];
  convexHull(list);
  expect(list).toEqual([
    [2, 0],
    [0, 0],
    [1, 1],
  ]);
});

test("is convex, holds every point, and is the hull of its own vertices", () => {
  forAll([points(1, 30, 2)], (list) => {
    const hull = convexHull(list);
    for (const vertex of hull) expect(list).toContainEqual(vertex);
    expect(convexHull(hull)).toEqual(hull);
    fc.pre(hull.length > 2);
    hull.forEach((vertex, i) => {
      const edge = sub(hull[(i + 1) % hull.length]!, vertex);
      const after = sub(hull[(i + 2) % hull.length]!, vertex);
      expect(cross2(edge, after)).toBeGreaterThan(0);
      for (const p of list) {
        expect(cross2(edge, sub(p, vertex)) / distance(edge, [0, 0])).toBeGreaterThan(-1e-8 * size(list));
      }
    });
  });
});

test("bad points are named", () => {
  expect(() => convexHull([])).toThrow("points: expected at least 1 point, got none");
  expect(() => convexHull([[1, 2, 3]])).toThrow("points[0]: expected 2 coordinates, got [1, 2, 3]");
  expect(() => convexHull([[1, Number.NaN]])).toThrow(/^points\[0\]\[1\]/);
});
