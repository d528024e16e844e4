import fc from "fast-check";
import { expect, test } from "vitest";
import {
  bezierIntersections,
  bezierPoint,
  bezierSegment,
  distance,
  elevateDegree,
  type Point,
} from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const arch: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];

test("two lines cross once", () => {
  const found = bezierIntersections(
    [
      [0, 0],
      [4, 4],
    ],
    [
      [0, 2],
      [4, 0],
    ],
    1e-9,
  )!;
  expect(found).toHaveLength(1);
  expect(found[0]!.t).toBeCloseTo(1 / 3, 12);
  expect(found[0]!.u).toBeCloseTo(1 / 3, 12);
  expect(distance(found[0]!.point, [4 / 3, 4 / 3])).toBeLessThan(1e-12);
});

test("a line through an arch, ascending along the first curve", () => {
  const found = bezierIntersections(
    arch,
    [
      [6, 1],
      [-1, 1],
    ],
    1e-9,
  )!;
  expect(found).toHaveLength(2);
  expect(found[0]!.t + found[1]!.t).toBeCloseTo(1, 12);
  expect(found[0]!.t).toBeLessThan(found[1]!.t);
  expect(found[0]!.u).toBeGreaterThan(found[1]!.u);
  for (const { point: p } of found) expect(p[1]).toBeCloseTo(1, 12);
});

test("two cubics can have nine common points", () => {
  const upright: Point[] = [
    [0, 0],
    [1 / 3, 20 / 3],
    [2 / 3, -17 / 3],
    [1, 1],
  ];
  const lying = upright.map((p) => [p[1]!, p[0]!]);
  expect(bezierIntersections(upright, lying, 1e-9)).toHaveLength(9);
});

test("touching counts once, common ends too, near misses not", () => {
  const touching = bezierIntersections(
    arch,
    [
      [0, 2.25],
      [5, 2.25],
    ],
    1e-9,
  )!;
  expect(touching).toHaveLength(1);
  expect(touching[0]!.t).toBeCloseTo(0.5, 4);
  expect(
    bezierIntersections(
      arch,
      [
        [0, 2.2501],
        [5, 2.2501],
      ],
      1e-9,
    ),
  ).toEqual([]);
  expect(
    bezierIntersections(
      arch,
      [
        [0, 2.2499],
        [5, 2.2499],
      ],
      1e-9,
    ),
  ).toHaveLength(2);
  const next = bezierIntersections(
    arch,
    [
      [5, 0],
      [6, -3],
      [9, -3],
      [10, 0],
    ],
    1e-9,
  )!;
  expect(next).toHaveLength(1);
  expect(next[0]!.t).toBeCloseTo(1, 9);
  expect(next[0]!.u).toBeCloseTo(0, 9);
  const osculating = bezierIntersections(
    [
      [-1, 1],
      [0, -1],
      [1, 1],
    ],
    [
      [-1, -1],
      [-1 / 3, 1],
      [1 / 3, -1],
      [1, 1],
    ].map((p) => [p[0]!, p[1]! ** 3 + p[0]! ** 2]),
    1e-6,
  );
  expect(osculating).not.toBeNull();
});

test("common pieces are null", () => {
  expect(bezierIntersections(arch, arch, 1e-9)).toBeNull();
  expect(bezierIntersections(arch, elevateDegree(bezierSegment(arch, 0.9, 0.2), 2), 1e-9)).toBeNull();
  expect(
    bezierIntersections(
      [
        [0, 0],
        [2, 2],
      ],
      [
        [1, 1],
        [5, 5],
      ],
      1e-9,
    ),
  ).toBeNull();
  expect(
    bezierIntersections(
      [[1, 1]],
      [
        [0, 0],
        [2, 2],
      ],
      1e-9,
    ),
  ).toBeNull();
});

test("far apart, or on a line but apart", () => {
  expect(
    bezierIntersections(
      arch,
      arch.map((p) => [p[0]!, p[1]! + 3]),
      1e-9,
    ),
  ).toEqual([]);
  expect(
    bezierIntersections(
      [
        [0, 0],
        [2, 2],
      ],
      [
        [3, 3],
        [5, 5],
      ],
      1e-9,
    ),
  ).toEqual([]);
});

test("every point reported is on both curves", () => {
  forAll([points(2, 5, 2), points(2, 5, 2)], (a, b) => {
    const accuracy = 1e-9 * size([...a, ...b]);
    for (const { t, u, point: p } of bezierIntersections(a, b, accuracy) ?? []) {
      expect(distance(bezierPoint(a, t), p)).toBeLessThanOrEqual(accuracy);
      expect(distance(bezierPoint(b, u), p)).toBeLessThanOrEqual(accuracy);
      expect(Math.min(t, u)).toBeGreaterThanOrEqual(0);
      expect(Math.max(t, u)).toBeLessThanOrEqual(1);
    }
  });
});

test("a planted common point is found", () => {
  const inner = unit.map((t) => 0.1 + 0.8 * t);
  forAll([points(2, 5, 2), points(2, 5, 2), inner, inner], (a, b, t, u) => {
    const p = bezierPoint(a, t);
    const q = bezierPoint(b, u);
    const moved = b.map((x) => [x[0]! + p[0]! - q[0]!, x[1]! + p[1]! - q[1]!]);
    const scale = size([...a, ...moved]);
    fc.pre(distance(a[0]!, a.at(-1)!) > 0.1 && distance(b[0]!, b.at(-1)!) > 0.1);
    const found = bezierIntersections(a, moved, 1e-6 * scale);
    const close = found === null || found.some((other) => distance(other.point, p) < 1e-4 * scale);
    expect(close).toBe(true);
  });
});

test("the order of the curves does not matter", () => {
  forAll([points(3, 4, 2), points(3, 4, 2)], (a, b) => {
    const accuracy = 1e-9 * size([...a, ...b]);
    const one = bezierIntersections(a, b, accuracy);
    const other = bezierIntersections(b, a, accuracy);
    expect(one?.length).toBe(other?.length);
  });
});

test("bad arguments are named", () => {
  expect(() => bezierIntersections([], arch, 1e-9)).toThrow(/^a: expected at least 1 point/);
  expect(() => bezierIntersections(arch, [[1, 2, 3]], 1e-9)).toThrow(/^b\[0\]: expected 2 coordinates/);
  expect(() => bezierIntersections(arch, arch, 0)).toThrow(/^accuracy: /);
});
