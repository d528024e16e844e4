import fc from "fast-check";
import { expect, test } from "vitest";
import { cubicDoublePoint, distance, type Point } from "../../src/math/index.ts";
import { coordinate, forAll } from "./property.ts";

const at = ([a, b, c, d]: readonly Point[], t: number): Point =>
  a!.map((_, axis) => ((a![axis]! * t + b![axis]!) * t + c![axis]!) * t + d![axis]!);

test("the nodal cubic (t², t³ − t) crosses itself in (1, 0) at a right angle", () => {
  const double = cubicDoublePoint([
    [0, 1],
    [1, 0],
    [0, -1],
    [0, 0],
  ]);
  expect(double.kind).toBe("node");
  expect(double.parameters).toEqual([-1, 1]);
  expect(double.point).toEqual([1, 0]);
  expect(double.tangents).toEqual([
    [-2, 2],
    [2, 2],
  ]);
  expect(double.angle).toBeCloseTo(Math.PI / 2, 14);
});

test("cusp, isolated point and none", () => {
  const empty = { tangents: [], angle: null };
  expect(
    cubicDoublePoint([
      [0, 1],
      [1, 0],
      [0, 0],
      [0, 0],
    ]),
  ).toEqual({
    ...empty,
    kind: "cusp",
    parameters: [0],
    point: [0, 0],
  });
  expect(
    cubicDoublePoint([
      [0, 1],
      [1, 0],
      [0, 1],
      [0, 0],
    ]),
  ).toEqual({
    ...empty,
    kind: "isolated",
    parameters: [],
    point: [-1, 0],
  });
  const none = { ...empty, kind: "none", parameters: [], point: null };
  expect(
    cubicDoublePoint([
      [0, 1],
      [0, 0],
      [1, -1],
      [0, 0],
    ]),
  ).toEqual(none);
  expect(
    cubicDoublePoint([
      [1, 2],
      [0, 0],
      [2, 4],
      [1, 2],
    ]),
  ).toEqual(none);
  expect(
    cubicDoublePoint([
      [0, 0],
      [1, 0],
      [0, 1],
      [0, 0],
    ]),
  ).toEqual(none);
  expect(
    cubicDoublePoint([
      [0.1, 0.3],
      [0.2, 0.6],
      [0, 1],
      [0, 0],
    ]),
  ).toEqual(none);
});

test("a shifted parameter shifts the parameters, and a cusp stays a cusp", () => {
  forAll([fc.double({ min: -3, max: 3, noNaN: true })], (s) => {
    // (t − s)² and (t − s)³ − k·(t − s), multiplied out.
    const shifted = (k: number): Point[] => [
      [0, 1],
      [1, -3 * s],
      [-2 * s, 3 * s * s - k],
      [s * s, -(s ** 3) + k * s],
    ];
    const cusp = cubicDoublePoint(shifted(0));
    expect(cusp.kind).toBe("cusp");
    expect(cusp.parameters[0]).toBeCloseTo(s, 9);
    const node = cubicDoublePoint(shifted(1));
    expect(node.kind).toBe("node");
    expect(node.parameters[0]).toBeCloseTo(s - 1, 9);
    expect(node.parameters[1]).toBeCloseTo(s + 1, 9);
    expect(distance(node.point!, [1, 0])).toBeLessThan(1e-9);
    expect(cubicDoublePoint(shifted(-1)).kind).toBe("isolated");
  });
});

test("neither the size of the curve nor the speed of its parameter matters", () => {
  for (const factor of [1e-6, 3, 1e6]) {
    for (const speed of [1e-3, 2, 1e3]) {
      // (t², t³ − k·t), scaled, with t replaced by speed · t.
      const curve = (k: number): Point[] =>
        [
          [0, speed ** 3],
          [speed ** 2, 0],
          [0, -k * speed],
          [1, 1],
        ].map((p) => p.map((x) => factor * x));
      const node = cubicDoublePoint(curve(1));
      expect(node.kind).toBe("node");
      expect(node.parameters[0]! * speed).toBeCloseTo(-1, 9);
      expect(node.parameters[1]! * speed).toBeCloseTo(1, 9);
      expect(node.point![0]! / factor).toBeCloseTo(2, 9);
      expect(cubicDoublePoint(curve(0)).kind).toBe("cusp");
      expect(cubicDoublePoint(curve(-1)).kind).toBe("isolated");
      expect(
        cubicDoublePoint(
          [
            [1e-13, 1],
            [0, 0.5],
            [1, 0],
            [0, 0],
          ].map((p) => p.map((x) => factor * x)),
        ).kind,
      ).toBe("none");
    }
  }
});

test("both parameters of a node lead to its point, and the tangents are the derivatives there", () => {
  const row = fc.tuple(coordinate, coordinate);
  forAll([row, row, row, row], (...coefficients) => {
    const { kind, parameters, point, tangents } = cubicDoublePoint(coefficients);
    if (kind !== "node") return;
    const reach = Math.max(1, ...parameters.map(Math.abs)) ** 3;
    fc.pre(reach < 1e6);
    const bound = 1e-9 * reach * 100;
    for (const [i, t] of parameters.entries()) {
      expect(distance(at(coefficients, t), point!)).toBeLessThan(bound);
      const [a, b, c] = coefficients;
      const derivative = [0, 1].map((axis) => (3 * a[axis]! * t + 2 * b[axis]!) * t + c[axis]!);
      expect(distance(derivative, tangents[i]!)).toBeLessThan(bound);
    }
    expect(parameters[0]).toBeLessThan(parameters[1]!);
  });
});

test("bad coefficients are named", () => {
  expect(() => cubicDoublePoint([[0, 1]])).toThrow("coefficients: expected at least 4 points, got 1");
  expect(() => cubicDoublePoint(new Array(5).fill([0, 1]))).toThrow(
    "coefficients: expected 4 points A, B, C, D, got 5",
  );
  expect(() => cubicDoublePoint(new Array(4).fill([0, 1, 2]))).toThrow(
    /^coefficients\[0\]: expected 2 coordinates/,
  );
});
