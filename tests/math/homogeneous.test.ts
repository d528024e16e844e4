import { expect, test } from "vitest";
import { fromHomogeneous, projectDerivatives, toHomogeneous } from "../../src/math/index.ts";

test("weights multiply the coordinates and follow as the last one", () => {
  expect(
    toHomogeneous(
      [
        [1, 2],
        [3, 4],
      ],
      [2, -1],
    ),
  ).toEqual([
    [2, 4, 2],
    [-3, -4, -1],
  ]);
  expect(fromHomogeneous([2, 4, 2])).toEqual([1, 2]);
  expect(fromHomogeneous([-3, -4, -1])).toEqual([3, 4]);
});

test("weight 0 is a point at infinity", () => {
  expect(fromHomogeneous([1, 2, 0])).toBeNull();
  expect(
    projectDerivatives([
      [1, 2, 0],
      [1, 1, 1],
    ]),
  ).toBeNull();
  expect(projectDerivatives([[1, 2, -0.5]], 0.5)).toBeNull();
  expect(projectDerivatives([[1, 2, -0.5]], 0.4)).toEqual([[-2, -4]]);
});

test("Leibniz' rule: derivatives of t / (1 + t)", () => {
  // a = t, w = 1 + t at t = 1; (t/(1+t))′ = 1/(1+t)², ″ = −2/(1+t)³, ‴ = 6/(1+t)⁴.
  const result = projectDerivatives([
    [1, 2],
    [1, 1],
    [0, 0],
    [0, 0],
  ])!;
  expect(result).toEqual([[1 / 2], [1 / 4], [-1 / 4], [3 / 8]]);
  // a = t², w = t² + 1 at t = 1.
  expect(
    projectDerivatives([
      [1, 2],
      [2, 2],
      [2, 2],
    ]),
  ).toEqual([[0.5], [0.5], [-0.5]]);
});

test("bad arguments are named", () => {
  expect(() => toHomogeneous([], [])).toThrow(/^points: /);
  expect(() => toHomogeneous([[1]], [1, 2])).toThrow(
    "weights: expected 1 weights, one for each control point, got 2",
  );
  expect(() => toHomogeneous([[1]], [0])).toThrow(/^weights: expected at least one weight other than 0/);
});
