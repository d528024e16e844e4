import fc from "fast-check";
import { expect, test } from "vitest";
import {
  curvePointsInto,
  distance,
  hermiteCurve,
  hermitePolynomial,
  hermiteSpline,
  interpolationNodes,
  maxError,
  parabolicBlending,
  runge,
  rungeDerivative,
  scale,
  sub,
} from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

const data = fc
  .uniqueArray(fc.integer({ min: -8, max: 8 }), { minLength: 2, maxLength: 5 })
  .chain((whole) => {
    const list = fc.array(point(2), { minLength: whole.length, maxLength: whole.length });
    return fc.tuple(fc.constant(whole.map((k) => k / 2)), list, list);
  });

test("meets points and tangents at every node, in any order", () => {
  forAll([data], ([nodes, points, tangents]) => {
    const p = hermitePolynomial(nodes, points, tangents);
    const tolerance = 1e-10 * size([...points, ...tangents]);
    const misses = nodes.map((t, i) =>
      Math.max(distance(p.point(t), points[i]!), distance(p.derivative(t), tangents[i]!)),
    );
    expect(Math.max(...misses)).toBeLessThan(tolerance);
    expect(p.domain).toEqual([Math.min(...nodes), Math.max(...nodes)]);
    expect(p.dimension).toBe(2);
  });
});

test("with two nodes it is the cubic of the two-point problem, in all derivatives", () => {
  forAll(
    [point(2), point(2), point(2), point(2), unit, fc.integer({ min: 0, max: 4 })],
    (p0, m0, p1, m1, t, r) => {
      const wanted = hermiteCurve(-1, 2, [p0, m0], [p1, m1]).derivative(t, r);
      const found = hermitePolynomial([-1, 2], [p0, p1], [m0, m1]).derivative(t, r);
      expect(distance(found, wanted)).toBeLessThan(1e-10 * size([p0, m0, p1, m1]));
    },
  );
});

test("its derivatives are limits of differences", () => {
  const p = hermitePolynomial([0, 1, 3], [[0], [2], [1]], [[1], [0], [-1]]);
  const e = 1e-5;
  for (const r of [1, 2, 3]) {
    const numeric = scale(sub(p.derivative(0.7 + e, r - 1), p.derivative(0.7 - e, r - 1)), 1 / (2 * e));
    expect(distance(numeric, p.derivative(0.7, r))).toBeLessThan(1e-5);
  }
  expect(p.derivative(0.7)).toEqual(p.derivative(0.7, 1));
  expect(p.split!(1)[1].domain).toEqual([1, 3]);
});

test("Runge's function, 15 nodes: 54.0 globally, 0.0016 in segments, 0.0198 by parabolic blending", () => {
  const nodes = interpolationNodes("equidistant", -5, 5, 14);
  const [points, tangents] = [nodes.map((x) => [runge(x)]), nodes.map((x) => [rungeDerivative(x)])];
  const whole = hermitePolynomial(nodes, points, tangents);
  expect(maxError(runge, (x) => whole.point(x)[0]!, -5, 5).error).toBeCloseTo(54.0, 1);
  const pieces = hermiteSpline(nodes, points, tangents);
  expect(maxError(runge, (x) => pieces.point(x)[0]!, -5, 5).error).toBeCloseTo(0.0016, 4);
  const blend = parabolicBlending(points);
  const place = (x: number) => ((x + 5) * 14) / 10;
  expect(maxError(runge, (x) => blend.point(place(x))[0]!, -5, 5).error).toBeCloseTo(0.0198, 4);
});

test("bad arguments are named", () => {
  const p = [[0], [1]];
  expect(() => hermitePolynomial([0], [[1]], [[1]])).toThrow("nodes: expected at least 2 numbers, got 1");
  expect(() => hermitePolynomial([0, 0], p, p)).toThrow(/^nodes\[1\]: /);
  expect(() => hermitePolynomial([0, 1], [[0]], p)).toThrow(/^points: expected 2 entries/);
  expect(() => hermitePolynomial([0, 1], p, [[0]])).toThrow(/^tangents: expected 2 entries/);
  expect(() => hermitePolynomial([0, 1], p, [[0], [1, 2]])).toThrow(/^tangents\[1\]: /);
  expect(() => hermitePolynomial([0, 1], [[0], [Number.NaN]], p)).toThrow(/^points\[1\]\[0\]: /);
});

test("the batch form samples a curve over its domain, both ends included", () => {
  const curve = hermiteCurve(1, 3, [[0, 0]], [[4, 2]]);
  const out = new Float64Array(8).fill(9);
  expect(curvePointsInto(out, curve, 2)).toBe(6);
  expect([...out]).toEqual([0, 0, 2, 1, 4, 2, 9, 9]);
  expect(() => curvePointsInto(out, curve, 0)).toThrow("steps: expected a whole number of at least 1, got 0");
});
