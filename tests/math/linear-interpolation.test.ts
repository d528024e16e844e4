import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  linearFromDistances,
  linearPosition,
  linearValue,
  piecewiseLinearPositions,
  piecewiseLinearValue,
} from "../../src/math/index.ts";
import { coordinate, forAll, point, unit } from "./property.ts";

describe("linear interpolation", () => {
  test("from distances: the nearer data point has the greater share", () => {
    expect(linearFromDistances(6, 9, 2, 1)!.value).toBeCloseTo(8, 14);
    expect(linearFromDistances(6, 9, 0, 5)).toEqual({ alpha: 0, value: 6 });
    expect(linearFromDistances(6, 9, 5, 0)).toEqual({ alpha: 1, value: 9 });
    expect(linearFromDistances(6, 9, 0, 0)).toBeNull();
    expect(linearFromDistances(0, 2, 1e308, 1e308)).toEqual({ alpha: 0.5, value: 1 });
  });

  test("distances and positions agree between the data points", () => {
    forAll([coordinate, coordinate, coordinate, coordinate, unit], (p1, v1, p2, v2, t) => {
      fc.pre(Math.abs(p1 - p2) > 1e-6);
      const p = (1 - t) * p1 + t * p2;
      const byPosition = linearValue(p1, v1, p2, v2, p)!;
      const byDistance = linearFromDistances(v1, v2, Math.abs(p - p1), Math.abs(p2 - p))!;
      expect(byPosition.alpha).toBeCloseTo(byDistance.alpha, 6);
      expect(byPosition.value).toBeCloseTo((1 - t) * v1 + t * v2, 3);
    });
  });

  test("position from value is the inverse of value from position", () => {
    forAll([coordinate, coordinate, coordinate, coordinate, unit], (p1, v1, p2, v2, t) => {
      fc.pre(Math.abs(p1 - p2) > 0.01 && Math.abs(v1 - v2) > 0.01);
      const { value } = linearValue(p1, v1, p2, v2, (1 - t) * p1 + t * p2)!;
      const { alpha, position } = linearPosition([p1], v1, [p2], v2, value)!;
      expect(alpha).toBeCloseTo(t, 9);
      expect(position[0]!).toBeCloseTo((1 - t) * p1 + t * p2, 7);
    });
  });

  test("both data points are met exactly, in any dimension", () => {
    forAll([point(3), coordinate, point(3), coordinate], (p1, v1, p2, v2) => {
      fc.pre(v1 !== v2);
      expect(linearPosition(p1, v1, p2, v2, v1)!.position.map(Math.abs)).toEqual(p1.map(Math.abs));
      expect(linearPosition(p1, v1, p2, v2, v2)!.position.map(Math.abs)).toEqual(p2.map(Math.abs));
    });
  });

  test("coincident data leave the answer open", () => {
    expect(linearValue(2, 1, 2, 5, 2)).toBeNull();
    expect(linearPosition([0], 3, [1], 3, 3)).toBeNull();
    expect(linearPosition([0], 0, [1], 5e-324, 1e300)).toBeNull();
    expect(linearPosition([0], -1.5e308, [1], 1.5e308, 0)).toEqual({ alpha: 0.5, position: [0.5] });
  });

  test("bad arguments are named", () => {
    expect(() => linearFromDistances(0, 1, -1, 2)).toThrow("d1: expected a distance of at least 0, got -1");
    expect(() => linearFromDistances(0, 1, 1, -2)).toThrow("d2: expected a distance of at least 0, got -2");
    expect(() => linearFromDistances(Number.NaN, 1, 1, 2)).toThrow(/^v1: /);
    expect(() => linearFromDistances(0, Number.NaN, 1, 2)).toThrow(/^v2: /);
    expect(() => linearFromDistances(0, 1, Number.NaN, 2)).toThrow(/^d1: expected a finite number/);
    expect(() => linearValue(Number.NaN, 1, 2, 3, 0)).toThrow(/^p1: /);
    expect(() => linearValue(0, 1, Number.NaN, 3, 0)).toThrow(/^p2: /);
    expect(() => linearValue(0, 1, 2, 3, Number.NaN)).toThrow("position: expected a finite number, got NaN");
    expect(() => linearPosition([0], 0, [1, 2], 1, 0)).toThrow("p2: expected 1 coordinate, got [1, 2]");
    expect(() => linearPosition([Number.NaN], 0, [1], 1, 0)).toThrow(/^p1\[0\]: /);
    expect(() => linearPosition([0], Number.NaN, [1], 1, 0)).toThrow(/^v1: /);
    expect(() => linearPosition([0], 0, [1], Number.NaN, 0)).toThrow(/^v2: /);
    expect(() => linearPosition([0], 0, [1], 1, Number.NaN)).toThrow(/^value: /);
  });
});

describe("piecewise linear interpolation", () => {
  const positions = [0, 1, 2.5, 4, 7];
  const values = [1, 3, 2, 2, -1];

  test("meets the data, halves the legs, holds the ends", () => {
    positions.forEach((x, i) => {
      expect(piecewiseLinearValue(positions, values, x)).toBe(values[i]);
    });
    expect(piecewiseLinearValue(positions, values, 5.5)).toBeCloseTo(0.5, 14);
    expect(piecewiseLinearValue(positions, values, -9)).toBe(1);
    expect(piecewiseLinearValue(positions, values, 99)).toBe(-1);
    expect(piecewiseLinearValue([3], [8], 3.5)).toBe(8);
    expect(piecewiseLinearValue([3], [8], 2.5)).toBe(8);
  });

  test("positions of a value: crossings, touched nodes, plateaus", () => {
    expect(piecewiseLinearPositions(positions, values, 2.5)).toEqual({
      positions: [0.75, 1.75],
      plateaus: [],
    });
    expect(piecewiseLinearPositions(positions, values, 2)).toEqual({
      positions: [0.5],
      plateaus: [[2.5, 4]],
    });
    expect(piecewiseLinearPositions(positions, values, 3)).toEqual({ positions: [1], plateaus: [] });
    expect(piecewiseLinearPositions(positions, values, 1)).toEqual({ positions: [0, 5], plateaus: [] });
    expect(piecewiseLinearPositions(positions, values, -1)).toEqual({ positions: [7], plateaus: [] });
    expect(piecewiseLinearPositions(positions, values, 4)).toEqual({ positions: [], plateaus: [] });
    expect(piecewiseLinearPositions([0, 1, 2, 5], [3, 3, 3, 3], 3)).toEqual({
      positions: [],
      plateaus: [[0, 5]],
    });
    expect(piecewiseLinearPositions([0, 1, 2, 3, 4], [3, 3, 0, 3, 3], 3)).toEqual({
      positions: [],
      plateaus: [
        [0, 1],
        [3, 4],
      ],
    });
    expect(piecewiseLinearPositions([2], [5], 5)).toEqual({ positions: [2], plateaus: [] });
    expect(piecewiseLinearPositions([2], [5], 4)).toEqual({ positions: [], plateaus: [] });
  });

  test("every position found has the value, in ascending order", () => {
    const data = fc.array(fc.integer({ min: -4, max: 4 }), { minLength: 1, maxLength: 9 });
    forAll([data, fc.integer({ min: -8, max: 8 })], (heights, half) => {
      const nodes = heights.map((_, i) => i);
      const found = piecewiseLinearPositions(nodes, heights, half / 2);
      found.positions.forEach((x, i) => {
        expect(piecewiseLinearValue(nodes, heights, x)).toBeCloseTo(half / 2, 12);
        if (i > 0) expect(x).toBeGreaterThan(found.positions[i - 1]!);
      });
      // Counted from outside: sign changes of the legs, nodes on the level that belong to no level leg.
      const level = heights.map((v) => Math.sign(v - half / 2));
      const crossings = level.slice(1).filter((s, i) => s * level[i]! === -1).length;
      const touched = level.filter((s, i) => s === 0 && level[i - 1] !== 0 && level[i + 1] !== 0).length;
      expect(found.positions.length).toBe(crossings + touched);
    });
  });

  test("bad arguments are named", () => {
    expect(() => piecewiseLinearValue([0, 0], [1, 2], 0)).toThrow(
      "positions[1]: expected a number greater than positions[0] = 0, got 0",
    );
    expect(() => piecewiseLinearValue([0, 1], [1], 0)).toThrow(
      "values: expected 2 entries, one for each of positions, got 1",
    );
    expect(() => piecewiseLinearValue([0, 1], [1, Number.NaN], 0)).toThrow(/^values\[1\]: /);
    expect(() => piecewiseLinearValue([0, 1], [1, 2], Number.NaN)).toThrow(/^x: /);
    expect(() => piecewiseLinearPositions([1, 0], [1, 2], 0)).toThrow(/^positions\[1\]: /);
    expect(() => piecewiseLinearPositions([0, 1], [1, 2], Number.NaN)).toThrow(/^target: /);
  });
});
