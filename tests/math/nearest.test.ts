import { expect, test } from "vitest";
import {
  bezierCurve,
  bezierNearest,
  bezierPoint,
  type Curve,
  distance,
  dot,
  nearest,
  type Point,
  sub,
} from "../../src/math/index.ts";
import { forAll, point, points, size, unit } from "./property.ts";

const arch: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];

test("a foot on a line, and the ends beyond it", () => {
  for (const find of [
    (target: Point) =>
      bezierNearest(
        [
          [0, 0],
          [4, 0],
        ],
        target,
      ),
    (target: Point) =>
      nearest(
        bezierCurve([
          [0, 0],
          [4, 0],
        ]),
        target,
        1e-12,
      ),
  ]) {
    const foot = find([1, 3]);
    expect(foot.t).toBeCloseTo(0.25, 7);
    expect(foot.distance).toBeCloseTo(3, 14);
    expect(foot.point[0]).toBeCloseTo(1, 6);
    expect(find([-3, 4])).toEqual({ t: 0, point: [0, 0], distance: 5 });
    expect(find([7, 4])).toEqual({ t: 1, point: [4, 0], distance: 5 });
  }
});

test("of two equally near points the first", () => {
  expect(bezierNearest(arch, [2.5, -10]).t).toBe(0);
  expect(bezierNearest([[0], [2], [0]], [0.5]).t).toBeCloseTo((1 - Math.SQRT1_2) / 2, 12);
  expect(nearest(bezierCurve(arch), [2.5, -10], 1e-9).t).toBe(0);
});

test("no point of the curve is nearer, and the way there is across the curve", () => {
  forAll([points(1, 6, 2), point(2), unit], (b, target, t) => {
    const found = bezierNearest(b, target);
    const slack = 1e-9 * (size(b) + size([target]));
    expect(found.point).toEqual(bezierPoint(b, found.t));
    expect(found.distance).toBe(distance(found.point, target));
    expect(distance(bezierPoint(b, t), target)).toBeGreaterThan(found.distance - slack);
    if (found.t > 1e-6 && found.t < 1 - 1e-6) {
      const across = dot(sub(found.point, target), bezierCurve(b).derivative(found.t));
      expect(Math.abs(across)).toBeLessThan(1e-6 * (size(b) + size([target])) ** 2);
    }
  });
});

test("the generic search finds the same", () => {
  forAll([points(2, 5), unit], (b, part) => {
    const target = b[0]!.map((x, axis) => x + (part - 0.3) * (axis + 1) * 7);
    const exact = bezierNearest(b, target);
    const found = nearest(bezierCurve(b), target, 1e-10);
    expect(Math.abs(found.distance - exact.distance)).toBeLessThan(1e-6 * (size(b) + size([target])));
    expect(found.t).toBeGreaterThanOrEqual(0);
    expect(found.t).toBeLessThanOrEqual(1);
  });
});

test("each smooth piece is searched, over any domain", () => {
  const tent: Curve = {
    dimension: 2,
    domain: [10, 14],
    breaks: [11],
    point: (t) => (t < 11 ? [t - 10, 0] : [1, t - 11]),
    derivative: (t) => (t < 11 ? [1, 0] : [0, 1]),
  };
  const found = nearest(tent, [3, 2.2], 1e-9, 2);
  expect(found.t).toBeCloseTo(13.2, 7);
  expect(found.distance).toBeCloseTo(2, 12);
  expect(nearest(tent, [2, -1], 1e-9, 2).t).toBeCloseTo(11, 8);
  expect(nearest(tent, [1, 9], 1e-9).t).toBe(14);
});

test("the accuracy asked for is worked for", () => {
  let calls = 0;
  const line = bezierCurve([
    [0, 0],
    [4, 0],
  ]);
  const counted: Curve = {
    ...line,
    point: (t) => {
      calls++;
      return line.point(t);
    },
  };
  const work = [1e-2, 1e-5, 1e-9].map((accuracy) => {
    calls = 0;
    nearest(counted, [1.234, 1], accuracy, 8);
    return calls;
  });
  expect(work[1]).toBeGreaterThan(work[0]! + 10);
  expect(work[2]).toBeGreaterThan(work[1]! + 10);
  expect(work[2]).toBeLessThan(80);
});

test("bad arguments are named", () => {
  expect(() => bezierNearest([], [1])).toThrow(/^controlPoints: /);
  expect(() => bezierNearest(arch, [1])).toThrow("target: expected 2 coordinates, got [1]");
  expect(() => nearest(bezierCurve(arch), [1], 1e-9)).toThrow(/^target: /);
  expect(() => nearest(bezierCurve(arch), [1, 2], 0)).toThrow(/^accuracy: /);
  expect(() => nearest(bezierCurve(arch), [1, 2], 1e-9, 1)).toThrow(
    "samples: expected a whole number of at least 2, got 1",
  );
});
