import fc from "fast-check";
import { expect, test } from "vitest";
import { bezierPatch, patchCurvatureSampler, surfaceCurvature, toFlatNet } from "../../src/math/index.ts";

const coordinate = fc.integer({ min: -40, max: 40 }).map((x) => x / 8);
const net = (m: number, n: number) =>
  fc.array(fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: n + 1, maxLength: n + 1 }), {
    minLength: m + 1,
    maxLength: m + 1,
  });

test("agrees with the curvatures of each place on its own", () => {
  const sample = patchCurvatureSampler(3, 2, 4, 3);
  const [gaussian, mean] = [new Float64Array(20), new Float64Array(20)];
  fc.assert(
    fc.property(net(3, 2), (points) => {
      sample(toFlatNet(points), gaussian, mean);
      const surface = bezierPatch(points);
      for (let a = 0; a <= 4; a++) {
        for (let b = 0; b <= 3; b++) {
          const [k, h] = [gaussian[4 * a + b]!, mean[4 * a + b]!];
          const expected = surfaceCurvature(surface, a / 4, b / 3);
          if (!expected || Number.isNaN(k)) continue;
          const size = Math.abs(expected.gaussian) + expected.mean ** 2;
          expect(Math.abs(k - expected.gaussian)).toBeLessThanOrEqual(1e-6 * (1 + size));
          expect(Math.abs(h - expected.mean)).toBeLessThanOrEqual(1e-6 * (1 + size));
        }
      }
    }),
    { numRuns: 200 },
  );
});

test("is exact on a paraboloid and on a saddle", () => {
  // z = x² + y² and z = x·y over the unit square: K = 4 and −1 at the origin.
  const one = new Float64Array(4);
  const bowl = [
    [[0, 0, 0], [0, 0.5, 0], [0, 1, 1]],
    [[0.5, 0, 0], [0.5, 0.5, 0], [0.5, 1, 1]],
    [[1, 0, 1], [1, 0.5, 1], [1, 1, 2]],
  ]; // biome-ignore format: a net
  const mean = new Float64Array(4);
  patchCurvatureSampler(2, 2, 1, 1)(toFlatNet(bowl), one, mean);
  expect(one[0]).toBeCloseTo(4, 12);
  expect(mean[0]).toBeCloseTo(2, 12);
  const saddle = [[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]]; // biome-ignore format: a net
  patchCurvatureSampler(1, 1, 1, 1)(toFlatNet(saddle), one, mean);
  expect(one[0]).toBeCloseTo(-1, 12);
  expect(mean[0]).toBeCloseTo(0, 12);
});

test("writes NaN where the tangents span no plane", () => {
  const tip = [[[0, 0, 0], [0, 0, 0]], [[1, 0, 0], [1, 1, 1]]]; // biome-ignore format: a net
  const values = new Float64Array(4).fill(7);
  patchCurvatureSampler(1, 1, 1, 1)(toFlatNet(tip), values);
  expect([...values].map(Number.isNaN)).toEqual([true, true, false, false]);
});

test("refuses degrees, steps and nets that do not fit", () => {
  expect(() => patchCurvatureSampler(0, 3, 4, 4)).toThrow(/^m: /);
  expect(() => patchCurvatureSampler(3, 3, 4, 0.5)).toThrow(/^stepsV: /);
  expect(() => patchCurvatureSampler(1, 1, 1, 1)([1, 2, 3], new Float64Array(4))).toThrow(/net: expected 12/);
});
