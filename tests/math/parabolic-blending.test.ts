import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  catmullRom,
  catmullRomSegment,
  combine,
  distance,
  lagrangePoint,
  type Point,
  parabolaPoint,
  parabolicBlend,
  parabolicBlending,
  parabolicCoefficients,
  sub,
} from "../../src/math/index.ts";
import { forAll, points, size, unit } from "./property.ts";

const several = points(3, 8, 2);

describe("parabolic blending", () => {
  test("a parabola meets its three points", () => {
    const [a, b, c]: Point[] = [
      [0, 1],
      [2, 3],
      [5, -1],
    ];
    expect(parabolaPoint(a!, b!, c!, -1)).toEqual(a);
    expect(parabolaPoint(a!, b!, c!, 0)).toEqual(b);
    expect(parabolaPoint(a!, b!, c!, 1)).toEqual(c);
    expect(parabolaPoint(a!, b!, c!, 0.5)).toEqual(combine([-1 / 8, 3 / 4, 3 / 8], [a!, b!, c!]));
  });

  test("the blend is (1 − t)·Q_r(t) + t·Q_{r+1}(t − 1); the ends keep one parabola", () => {
    forAll([several, unit], (p, t) => {
      for (let r = 0; r + 1 < p.length; r++) {
        const first = r > 0 ? lagrangePoint([-1, 0, 1], p.slice(r - 1, r + 2), t) : null;
        const second = r + 2 < p.length ? lagrangePoint([0, 1, 2], p.slice(r, r + 3), t) : null;
        const wanted = first && second ? combine([1 - t, t], [first, second]) : (first ?? second)!;
        expect(distance(parabolicBlend(p, r, t), wanted)).toBeLessThan(1e-12 * size(p));
      }
    });
  });

  test("the curve, its coefficients and the blend are one; it is the uniform Catmull-Rom spline", () => {
    forAll([several, unit], (p, t) => {
      const curve = parabolicBlending(p);
      const spline = catmullRom(p, 0);
      const coefficients = parabolicCoefficients(p);
      const tolerance = 1e-12 * size(p);
      for (let r = 0; r + 1 < p.length; r++) {
        const blend = parabolicBlend(p, r, t);
        expect(distance(curve.point(r + t), blend)).toBeLessThan(20 * tolerance);
        expect(distance(spline.point(r + t), blend)).toBeLessThan(20 * tolerance);
        expect(distance(combine([t ** 3, t ** 2, t, 1], coefficients[r]!), blend)).toBeLessThan(tolerance);
      }
      expect(coefficients.length).toBe(p.length - 1);
      expect(curve.domain).toEqual([0, p.length - 1]);
    });
  });

  test("tangents: half the difference of the neighbours; at the ends those of the parabolas", () => {
    const p = [[0], [1], [4], [2]];
    expect(parabolicBlending(p).tangents).toEqual([[0], [2], [0.5], [-4.5]]);
  });

  test("is local: a point acts on four segments", () => {
    const flat = Array.from({ length: 9 }, (_, i): Point => [i, 0]);
    const bump = flat.map(([x], i): Point => [x!, i === 4 ? 1 : 0]);
    for (const r of [0, 1, 6, 7]) expect(parabolicBlend(bump, r, 0.3)).toEqual(parabolicBlend(flat, r, 0.3));
    for (const r of [2, 3, 4, 5])
      expect(parabolicBlend(bump, r, 0.3)).not.toEqual(parabolicBlend(flat, r, 0.3));
  });

  test("bad arguments are named", () => {
    const p = [[0], [1], [4], [2]];
    expect(() => parabolicBlend(p.slice(0, 2), 0, 0)).toThrow("points: expected at least 3 points, got 2");
    expect(() => parabolicBlend(p, 3, 0)).toThrow("r: expected a whole number from 0 to 2, got 3");
    expect(() => parabolicBlend(p, -1, 0)).toThrow(/^r: /);
    expect(() => parabolicBlend(p, 0, Number.NaN)).toThrow(/^t: /);
    expect(() => parabolicBlending(p.slice(0, 2))).toThrow("points: expected at least 3 points, got 2");
    expect(() => parabolicCoefficients(p.slice(0, 2))).toThrow(/^points: /);
  });
});

describe("Catmull-Rom", () => {
  const alpha = fc.constantFrom(0, 0.5, 1);
  const apart = points(3, 8, 3).filter((p) => p.every((q, i) => i === 0 || distance(q, p[i - 1]!) > 1e-3));

  test("each tangent is that of the parabola through the point and its neighbours; the end pieces are parabolas", () => {
    forAll([apart, alpha, unit], (p, a, u) => {
      const { nodes, tangents, point } = catmullRom(p, a);
      const last = p.length - 1;
      const parabola = (middle: number, t: number, r: number) =>
        lagrangePoint(nodes.slice(middle - 1, middle + 2), p.slice(middle - 1, middle + 2), t, r);
      p.forEach((_, r) => {
        const middle = Math.min(Math.max(r, 1), last - 1);
        const wanted = parabola(middle, nodes[r]!, 1);
        expect(distance(tangents[r]!, wanted)).toBeLessThan(1e-9 * (1 + size([wanted])) * size(p));
      });
      const t = nodes[0]! + u * (nodes[1]! - nodes[0]!);
      expect(distance(point(t), parabola(1, t, 0))).toBeLessThan(1e-9 * size(p) ** 2);
      const s = nodes[last]! - u * (nodes[last]! - nodes[last - 1]!);
      expect(distance(point(s), parabola(last - 1, s, 0))).toBeLessThan(1e-9 * size(p) ** 2);
    });
  });

  test("the segment of four points is the middle one, with tangents in the local parameter", () => {
    forAll([apart.filter((p) => p.length >= 4).map((p) => p.slice(0, 4)), alpha, unit], (p, a, u) => {
      const spline = catmullRom(p, a);
      const segment = catmullRomSegment(p, a);
      const h = spline.nodes[2]! - spline.nodes[1]!;
      const tolerance = 1e-11 * size(p);
      expect(distance(segment.point(u), spline.point(spline.nodes[1]! + u * h))).toBeLessThan(tolerance);
      const e = 1e-6;
      const numeric = sub(segment.point(e), segment.point(-e)).map((x) => x / (2 * e));
      expect(distance(segment.startTangent, numeric)).toBeLessThan(
        1e-6 * size([segment.startTangent, segment.endTangent, ...p]),
      );
    });
    expect(catmullRomSegment([[0], [1], [3], [8]], 0).endTangent).toEqual([3.5]);
  });

  test("bad arguments are named", () => {
    expect(() => catmullRom([[0], [1]], 0)).toThrow("points: expected at least 3 points, got 2");
    expect(() => catmullRom([[0], [1], [1]], 1)).toThrow(/^points\[2\]: expected a point apart/);
    expect(() => catmullRomSegment([[0], [1], [2]], 0)).toThrow("points: expected 4 points, got 3");
    expect(() => catmullRomSegment([[0], [1], [2], [3], [4]], 0)).toThrow("points: expected 4 points, got 5");
  });
});
