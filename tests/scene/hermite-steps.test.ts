import { expect, test } from "vitest";
import { bezierDerivative, bezierPoint } from "../../src/math/index.ts";
import { evenly, hermiteSteps } from "../../src/scene/hermite-steps.ts";
import { interpolantSteps } from "../../src/scene/interpolant-steps.ts";

const cubic = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];

test("a cubic in one piece keeps its own control points", () => {
  const steps = hermiteSteps(
    (t) => bezierPoint(cubic, t),
    (t) => bezierDerivative(cubic, t),
    [0, 1],
  );
  expect(steps).toEqual([
    ["M", [0, 0]],
    ["C", ...cubic.slice(1)],
  ]);
});

test("the interpolating polynomial passes through its points at equal distances of the parameter", () => {
  const points = [
    [0, 0],
    [1, 3],
    [2, -1],
    [3, 2],
    [4, 0],
  ];
  const ends = interpolantSteps(points).map((step) => step.at(-1) as number[]);
  const every = (ends.length - 1) / 4;
  points.forEach((point, i) => {
    ends[i * every]!.forEach((x, axis) => {
      expect(x).toBeCloseTo(point[axis]!, 12);
    });
  });
});

test("two points are joined by a straight line", () => {
  const [, step] = interpolantSteps([
    [0, 0],
    [3, 6],
  ]);
  expect(step).toEqual(["C", [1, 2], [2, 4], [3, 6]]);
});

test("evenly spaced parameters begin and end exactly", () => {
  expect(evenly(0, 1, 4)).toEqual([0, 0.25, 0.5, 0.75, 1]);
});
