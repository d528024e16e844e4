import fc from "fast-check";
import { expect, test } from "vitest";
import { bezierPoint, blossom, distance, lerp, type Point } from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

/** Control points of degree n with n parameters. */
const pair = fc
  .integer({ min: 0, max: 6 })
  .chain((n) =>
    fc.tuple(
      fc.array(point(2), { minLength: n + 1, maxLength: n + 1 }),
      fc.array(unit, { minLength: n, maxLength: n }),
    ),
  );

test("is symmetric", () => {
  forAll([pair, fc.infiniteStream(unit)], ([b, ts], order) => {
    const shuffled = ts
      .map((t) => ({ t, key: order.next().value as number }))
      .sort((p, q) => p.key - q.key)
      .map(({ t }) => t);
    expect(distance(blossom(b, ts), blossom(b, shuffled))).toBeLessThan(1e-12 * size(b));
    expect(distance(blossom(b, ts), blossom(b, [...ts].reverse()))).toBeLessThan(1e-12 * size(b));
  });
});

test("is affine in each argument", () => {
  forAll([pair, unit, unit, unit], ([b, ts], s, t, mix) => {
    fc.pre(ts.length > 0);
    const rest = ts.slice(1);
    const mixed = blossom(b, [(1 - mix) * s + mix * t, ...rest]);
    const expected = lerp(blossom(b, [s, ...rest]), blossom(b, [t, ...rest]), mix);
    expect(distance(mixed, expected)).toBeLessThan(1e-12 * size(b));
  });
});

test("is the curve on the diagonal and the control points at zeros and ones", () => {
  forAll([pair, unit], ([b, ts], t) => {
    const n = ts.length;
    expect(blossom(b, new Array(n).fill(t))).toEqual(bezierPoint(b, t));
    b.forEach((p, i) => {
      const arguments01 = [...new Array(n - i).fill(0), ...new Array(i).fill(1)];
      expect(distance(blossom(b, arguments01), p)).toBe(0);
    });
  });
});

test("bad arguments are named", () => {
  const line: Point[] = [[0], [1]];
  expect(() => blossom(line, [])).toThrow("ts: expected 1 parameters, one for each degree, got 0");
  expect(() => blossom(line, [0, 1])).toThrow(/^ts: /);
  expect(() => blossom(line, [Number.NaN])).toThrow("ts[0]: expected a finite number, got NaN");
  expect(() => blossom([], [])).toThrow(/^controlPoints: /);
});
