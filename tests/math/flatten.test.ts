import { expect, test } from "vitest";
import {
  bezierChordCount,
  bezierCurve,
  bezierPoint,
  type Curve,
  distance,
  distanceToSegment,
  flatten,
  lerp,
  type Point,
} from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const arch: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];

test("the distance from a segment is to its ends beyond it", () => {
  expect(distanceToSegment([1, 3], [0, 0], [4, 0])).toBe(3);
  expect(distanceToSegment([-3, 4], [0, 0], [4, 0])).toBe(5);
  expect(distanceToSegment([7, 4], [0, 0], [4, 0])).toBe(5);
  expect(distanceToSegment([3, 4], [0, 0], [0, 0])).toBe(5);
});

test("the polyline runs from the start to the end through points of the curve", () => {
  const { ts, points: vertices } = flatten(bezierCurve(arch, [1, 3]), 0.01);
  expect(ts[0]).toBe(1);
  expect(ts.at(-1)).toBe(3);
  expect(vertices).toHaveLength(ts.length);
  ts.forEach((t, i) => {
    expect(distance(vertices[i]!, bezierPoint(arch, (t - 1) / 2))).toBeLessThan(1e-14);
    if (i > 0) expect(t).toBeGreaterThan(ts[i - 1]!);
  });
});

test("the curve stays within the tolerance", () => {
  forAll([points(2, 6), unit], (b, part) => {
    const curve = bezierCurve(b);
    const tolerance = 0.003 * size(b);
    const { ts, points: vertices } = flatten(curve, tolerance);
    for (let i = 1; i < ts.length; i++) {
      const p = curve.point(ts[i - 1]! + part * (ts[i]! - ts[i - 1]!));
      expect(distanceToSegment(p, vertices[i - 1]!, vertices[i]!)).toBeLessThanOrEqual(tolerance);
    }
  });
});

test("a straight line takes four pieces, a finer tolerance more of an arch, but not too many", () => {
  expect(
    flatten(
      bezierCurve([
        [0, 0],
        [1, 1],
        [2, 2],
        [3, 3],
      ]),
      1e-6,
    ).ts,
  ).toEqual([0, 0.25, 0.5, 0.75, 1]);
  const counts = [1, 1e-2, 1e-4, 1e-6].map(
    (tolerance) => flatten(bezierCurve(arch), tolerance).ts.length - 1,
  );
  expect(counts[0]).toBe(4);
  for (let i = 1; i < counts.length; i++) {
    expect(counts[i]).toBeGreaterThan(counts[i - 1]!);
    expect(counts[i]).toBeLessThanOrEqual(3 * bezierChordCount(arch, 10 ** (-2 * i)));
  }
});

test("breaks are vertices; a wild curve ends", () => {
  const corner: Curve = {
    dimension: 2,
    domain: [-1, 2],
    breaks: [0.3],
    point: (t) => [t, Math.abs(t - 0.3)],
    derivative: () => [1, 1],
  };
  expect(flatten(corner, 1e-9).ts).toHaveLength(9);
  expect(flatten(corner, 1e-9).ts).toContain(0.3);
  const jump: Curve = { ...corner, breaks: [], point: (t) => [t, t < 0.123 ? 0 : 1] };
  const { ts } = flatten(jump, 1e-3);
  expect(ts.length).toBeGreaterThan(10);
  expect(ts.length).toBeLessThan(60);
});

test("so many equal parameter steps stay within the tolerance, proven", () => {
  expect(
    bezierChordCount(
      [
        [0, 0],
        [3, 4],
      ],
      1e-9,
    ),
  ).toBe(1);
  expect(bezierChordCount([[5, 5]], 1e-9)).toBe(1);
  // p″ = 2·(b_2 − 2b_1 + b_0) = (0, −4): chord error over h is h²/2.
  expect(
    bezierChordCount(
      [
        [0, 0],
        [1, 1],
        [2, 0],
      ],
      0.5,
    ),
  ).toBe(1);
  expect(
    bezierChordCount(
      [
        [0, 0],
        [1, 1],
        [2, 0],
      ],
      0.125,
    ),
  ).toBe(2);
  expect(
    bezierChordCount(
      [
        [0, 0],
        [1, 1],
        [2, 0],
      ],
      0.12,
    ),
  ).toBe(3);
  forAll([points(2, 7), unit], (b, t) => {
    const tolerance = 0.01 * size(b);
    const count = bezierChordCount(b, tolerance);
    const i = Math.min(count - 1, Math.floor(t * count));
    const chord = lerp(bezierPoint(b, i / count), bezierPoint(b, (i + 1) / count), t * count - i);
    expect(distance(chord, bezierPoint(b, t))).toBeLessThanOrEqual(tolerance * (1 + 1e-9));
  });
});

test("bad arguments are named", () => {
  expect(() => flatten(bezierCurve(arch), 0)).toThrow("tolerance: expected a positive finite number, got 0");
  expect(() => bezierChordCount(arch, Number.NaN)).toThrow(/^tolerance: /);
  expect(() => bezierChordCount([], 1)).toThrow(/^controlPoints: /);
});
