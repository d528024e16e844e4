import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  bernsteinAll,
  bezierPoint,
  bsplineBasis,
  bsplineCurve,
  bsplineHodograph,
  bsplineToBezier,
  checkCurveKnots,
  checkKnots,
  clampedKnots,
  combine,
  coxDeBoor,
  deBoor,
  deCasteljau,
  distance,
  findSpan,
  insertKnot,
  knotBreaks,
  knotDomain,
  multiplicity,
  norm,
  nurbsCircle,
  nurbsCurve,
  nurbsDerivative,
  nurbsToBezier,
  type Point,
  periodicControlPoints,
  rationalBezierPoint,
  uniformKnots,
} from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

/** Valid knots of a curve: random gaps, inner knots at most `degree` times, clamped or not. */
const spline = fc
  .tuple(fc.integer({ min: 1, max: 4 }), fc.integer({ min: 0, max: 6 }))
  .chain(([degree, extra]) =>
    fc.tuple(
      fc.constant(degree),
      fc.array(fc.constantFrom(0, 0, 0.25, 0.5, 1), {
        minLength: 2 * degree + 1 + extra,
        maxLength: 2 * degree + 1 + extra,
      }),
      fc.array(point(2), { minLength: degree + 1 + extra, maxLength: degree + 1 + extra }),
    ),
  )
  .map(([degree, gaps, controlPoints]) => {
    const knots = [-1];
    // A gap after `degree` equal knots keeps the multiplicity in bounds; the first span of the domain is not empty.
    gaps.forEach((gap, i) => {
      const full = i + 1 >= degree && knots[i + 1 - degree] === knots[i];
      knots.push(knots[i]! + (gap === 0 && (full || i === degree) ? 0.75 : gap));
    });
    return { degree, knots, controlPoints };
  });
/** A spline with a parameter in its domain, often at a knot. */
const at = fc.tuple(spline, unit, fc.boolean(), fc.nat()).map(([s, u, onKnot, k]) => {
  const [a, b] = knotDomain(s.degree, s.knots);
  const breaks = knotBreaks(s.degree, s.knots);
  return { ...s, t: onKnot ? breaks[k % breaks.length]! : Math.min(a + u * (b - a), b) };
});
const flat = (points: readonly Point[]) => points.flat();

describe("knots", () => {
  test("makers", () => {
    expect(clampedKnots(2, 5)).toEqual([0, 0, 0, 1 / 3, 2 / 3, 1, 1, 1]);
    expect(clampedKnots(3, 4, [2, 5])).toEqual([2, 2, 2, 2, 5, 5, 5, 5]);
    expect(clampedKnots(1, 4, [2, 8])).toEqual([2, 2, 4, 6, 8, 8]);
    expect(clampedKnots(0, 3, [0, 0.3]).at(-1)).toBe(0.3);
    expect(uniformKnots(3, 5)).toEqual([-3, -2, -1, 0, 1, 2, 3, 4, 5]);
    expect(knotDomain(3, uniformKnots(3, 5))).toEqual([0, 2]);
    expect(periodicControlPoints(2, ["a", "b", "c"])).toEqual({
      knots: [-2, -1, 0, 1, 2, 3, 4, 5],
      controlPoints: ["a", "b", "c", "a", "b"],
    });
  });

  test("breaks and multiplicity", () => {
    const knots = [0, 0, 0, 1, 1, 2, 3, 3, 4];
    expect(knotBreaks(2, knots)).toEqual([0, 1, 2, 3]);
    expect([0, 1, 2, 2.5].map((t) => multiplicity(knots, t))).toEqual([3, 2, 1, 0]);
    expect(knotBreaks(1, knots)).toEqual([0, 1, 2, 3]);
  });

  test("the span holds t, is not empty and lies in the domain", () => {
    forAll([at], ({ degree, knots, controlPoints, t }) => {
      const k = findSpan(degree, knots, t);
      const end = knots[controlPoints.length]!;
      expect(k >= degree && k < controlPoints.length && knots[k]! < knots[k + 1]!).toBe(true);
      expect(knots[k]! <= t && (t < knots[k + 1]! || (t === end && knots[k + 1] === end))).toBe(true);
    });
    expect([-9, 0, 0.5, 1, 1.5, 2, 9].map((t) => findSpan(2, [0, 0, 0, 1, 1, 2, 2, 2], t))).toEqual([
      2, 2, 2, 4, 4, 4, 4,
    ]);
    expect(findSpan(2, [-2, -1, -1, -1, 0, 1, 1], -5)).toBe(3);
    expect(findSpan(1, [0, 0, 1, 2, 2, 2], 2)).toBe(2);
  });

  test("bad knots are named", () => {
    expect(() => checkKnots(2, [0, 0, 0, 1, 1], 3)).toThrow(
      "knots: expected 6 = 3 control points + degree 2 + 1 knots, got 5",
    );
    expect(() => checkKnots(2, [0, 0, 1, 1, 1], 2)).toThrow(
      "knots: expected at least 2·(degree + 1) = 6 knots, for degree + 1 control points, got 5",
    );
    expect(() => checkKnots(1, [0, 1, 0.5, 2], 2)).toThrow(
      "knots[2]: expected a number of at least knots[1] = 1, got 0.5",
    );
    expect(() => checkKnots(1, [0, 1, 1, 1, 2], 3)).toThrow(
      "knots[1]: expected a knot at most degree + 1 = 2 times, got 1 more often",
    );
    expect(() => checkKnots(1, [0, 1, 1, 1], 2)).toThrow(/^knots\[1\]: expected a knot at most/);
    expect(() => checkKnots(2, [0, 1, 2, 2, 3, 4], 3)).toThrow(
      "knots: expected a domain [knots[2], knots[3]] that is not empty, got [2, 2]",
    );
    expect(() => checkKnots(-1, [0], 2)).toThrow(/^degree: /);
    expect(() => checkKnots(1, [0, Number.NaN, 1, 2], 2)).toThrow(/^knots\[1\]: /);
    expect(() => checkCurveKnots(1, [0, 0, 1, 2, 2], 3)).not.toThrow();
    expect(() => checkCurveKnots(2, [0, 0, 0, 1, 1, 1, 2, 2, 2], 6)).toThrow(
      "knots[3]: expected an inner knot at most degree = 2 times, got 1 more often; the curve would be torn there",
    );
    expect(() => checkCurveKnots(2, [0, 0, 0, 1, 1, 2, 2, 2], 5)).not.toThrow();
    expect(() => checkCurveKnots(0, [0, 1, 2], 2)).not.toThrow();
    expect(() => checkCurveKnots(1, [0, 0, 1], 2)).toThrow(/^knots: /);
    expect(() => clampedKnots(2, 2)).toThrow("count: expected a whole number of at least 3, got 2");
    expect(() => clampedKnots(-1, 2)).toThrow(/^degree: /);
    expect(() => clampedKnots(1, 2, [1, 1])).toThrow(/^domain/);
    expect(() => uniformKnots(2, 2)).toThrow(/^count: /);
    expect(() => uniformKnots(0.5, 2)).toThrow(/^degree: /);
    expect(() => periodicControlPoints(0, [1])).toThrow(/^degree: /);
    expect(() => periodicControlPoints(3, [1, 2])).toThrow(
      "controlPoints.length: expected a whole number of at least 3, got 2",
    );
  });
});

describe("basis functions", () => {
  test("are not negative, add up to 1 on the domain and vanish off their support", () => {
    forAll([at], ({ degree, knots, t }) => {
      const values = bsplineBasis(degree, knots, t);
      expect(values.reduce((sum, x) => sum + x, 0)).toBeCloseTo(1, 13);
      expect(Math.min(...values)).toBeGreaterThanOrEqual(0);
      expect(values.every((x, i) => x === 0 || (t >= knots[i]! && t <= knots[i + degree + 1]!))).toBe(true);
      const levels = coxDeBoor(degree, knots, t);
      expect(levels.map((level) => level.length)).toEqual(levels.map((_, q) => knots.length - 1 - q));
      expect(levels.at(-1)).toEqual(values);
    });
  });

  test("with knots 0 … 0, 1 … 1 they are the Bernstein polynomials", () => {
    forAll([fc.integer({ min: 0, max: 6 }), unit], (n, t) => {
      expect(distance(bsplineBasis(n, clampedKnots(n, n + 1), t), bernsteinAll(n, t))).toBeLessThan(1e-13);
    });
  });

  test("derivatives are limits of differences, from the right", () => {
    forAll([at, fc.integer({ min: 1, max: 3 })], ({ degree, knots, t }, r) => {
      const [, b] = knotDomain(degree, knots);
      const next = knotBreaks(degree, knots).find((knot) => knot > t) ?? b;
      fc.pre(next - t > 0.01);
      // A central difference about a place inside the span, followed to it by the next derivative.
      const e = 1e-4;
      const near = bsplineBasis(degree, knots, t + 2 * e, r - 1);
      const far = bsplineBasis(degree, knots, t + 4 * e, r - 1);
      const numeric = near.map((x, i) => (far[i]! - x) / (2 * e));
      const wanted = bsplineBasis(degree, knots, t + 3 * e, r);
      expect(distance(numeric, wanted)).toBeLessThan(1e-3 * size([wanted]));
      // From the right: t belongs to the same polynomial as the places after it.
      const rate = bsplineBasis(degree, knots, t + 3 * e, r + 1);
      const back = wanted.map((x, i) => x - 3 * e * rate[i]!);
      expect(distance(bsplineBasis(degree, knots, t, r), back)).toBeLessThan(1e-3 * size([rate]));
    });
    expect(bsplineBasis(1, [0, 0, 1, 2, 2], 1, 1)).toEqual([0, -1, 1]);
    expect(bsplineBasis(1, [0, 0, 1, 2, 2], 2, 1)).toEqual([0, -1, 1]);
    expect(bsplineBasis(2, [0, 0, 0, 1, 1, 1], 0.5, 2)).toEqual([2, -4, 2]);
    expect(bsplineBasis(2, [0, 0, 0, 1, 1, 1], 0.5, 3)).toEqual([0, 0, 0]);
  });

  test("outside the domain they are those of the whole knot vector, and 0 beyond it", () => {
    const knots = uniformKnots(2, 3);
    expect(bsplineBasis(2, knots, -1.5)).toEqual([0.125, 0, 0]);
    expect(bsplineBasis(2, knots, 2.5)).toEqual([0, 0, 0.125]);
    expect(bsplineBasis(2, knots, -2)).toEqual([0, 0, 0]);
    expect(bsplineBasis(2, knots, -3)).toEqual([0, 0, 0]);
    expect(bsplineBasis(2, knots, 3.5)).toEqual([0, 0, 0]);
    expect(coxDeBoor(2, knots, 0.5)[0]).toEqual([0, 0, 1, 0, 0]);
    expect(coxDeBoor(2, knots, 3)[0]).toEqual([0, 0, 0, 0, 1]);
  });

  test("bad arguments are named", () => {
    expect(() => bsplineBasis(1, [0, 1, 0, 2], 0)).toThrow(/^knots\[2\]: /);
    expect(() => bsplineBasis(1, [0, 0, 1, 1], Number.NaN)).toThrow(/^t: /);
    expect(() => bsplineBasis(1, [0, 0, 1, 1], 0, -1)).toThrow(/^r: /);
    expect(() => coxDeBoor(1, [0, 1], 0)).toThrow(/^knots: /);
    expect(() => coxDeBoor(1, [0, 0, 1, 1], Number.NaN)).toThrow(/^t: /);
  });
});

describe("de Boor", () => {
  test("gives Σ d_i·N_i(t) and every level", () => {
    forAll([at], ({ degree, knots, controlPoints, t }) => {
      const { span, levels } = deBoor(degree, knots, controlPoints, t);
      const sum = combine(bsplineBasis(degree, knots, t), controlPoints);
      expect(distance(levels[degree]![0]!, sum)).toBeLessThan(1e-12 * size(controlPoints));
      expect(span).toBe(findSpan(degree, knots, t));
      expect(levels[0]).toEqual(controlPoints.slice(span - degree, span + 1));
      expect(levels.map((level) => level.length)).toEqual(levels.map((_, r) => degree + 1 - r));
    });
  });

  test("with knots 0 … 0, 1 … 1 it is de Casteljau's construction", () => {
    const b = [
      [0, 0],
      [1, 2],
      [3, 2],
      [4, 0],
    ];
    const { levels } = deBoor(3, clampedKnots(3, 4), b, 0.3);
    levels.forEach((level, r) => {
      expect(distance(flat(level), flat(deCasteljau(b, 0.3)[r]!))).toBeLessThan(1e-15);
    });
  });

  test("bad arguments are named", () => {
    expect(() => deBoor(1, [0, 0, 1, 1], [], 0)).toThrow(/^controlPoints: /);
    expect(() => deBoor(1, [0, 1, 1], [[0], [1]], 0)).toThrow(/^knots: /);
    expect(() => deBoor(1, [0, 0, 1, 1], [[0], [1]], Number.NaN)).toThrow(/^t: /);
  });
});

describe("the curve", () => {
  test("derivatives are Σ d_i·N_i^{(r)}(t), at knots too", () => {
    forAll([at, fc.integer({ min: 0, max: 5 })], ({ degree, knots, controlPoints, t }, r) => {
      const curve = bsplineCurve(degree, knots, controlPoints);
      const wanted = combine(bsplineBasis(degree, knots, t, r), controlPoints);
      expect(distance(curve.derivative(t, r), wanted)).toBeLessThan(
        1e-10 * size([wanted, ...controlPoints]) * 30 ** r,
      );
      if (r === 0) expect(curve.point(t)).toEqual(curve.derivative(t, 0));
      if (r === 1) expect(curve.derivative(t)).toEqual(curve.derivative(t, 1));
    });
  });

  test("is local: a control point acts on its support only", () => {
    forAll([at, fc.nat()], ({ degree, knots, controlPoints, t }, k) => {
      const i = k % controlPoints.length;
      const moved = controlPoints.map((p, j) => (j === i ? [p[0]! + 1, p[1]!] : p));
      const before = bsplineCurve(degree, knots, controlPoints).point(t);
      const after = bsplineCurve(degree, knots, moved).point(t);
      if (t < knots[i]! || t > knots[i + degree + 1]!) expect(after).toEqual(before);
      else expect(after[0]! - before[0]!).toBeCloseTo(bsplineBasis(degree, knots, t)[i]!, 10);
    });
  });

  test("is a curve: domain, breaks, a bound for its speed, pieces", () => {
    forAll([at], ({ degree, knots, controlPoints, t }) => {
      const curve = bsplineCurve(degree, knots, controlPoints);
      expect(norm(curve.derivative(t))).toBeLessThanOrEqual(curve.speed! * (1 + 1e-12) + 1e-12);
      expect([curve.domain[0], ...curve.breaks!, curve.domain[1]]).toEqual(knotBreaks(degree, knots));
    });
    const curve = bsplineCurve(
      2,
      [0, 0, 0, 1, 2, 2, 2],
      [
        [0, 0],
        [1, 2],
        [3, 2],
        [4, 0],
      ],
    );
    expect(curve.speed).toBeCloseTo(2 * Math.hypot(1, 2), 14);
    expect([curve.domain, curve.breaks, curve.dimension]).toEqual([[0, 2], [1], 2]);
    const [left, right] = curve.split!(0.5);
    expect([left.domain, left.breaks, right.domain, right.breaks]).toEqual([[0, 0.5], [], [0.5, 2], [1]]);
    expect(right.point(1.5)).toEqual(curve.point(1.5));
    expect(right.split!(1).map(({ breaks }) => breaks)).toEqual([[], []]);
  });

  test("a closed curve is C² where it closes", () => {
    const { knots, controlPoints } = periodicControlPoints(3, [
      [0, 0],
      [4, 0],
      [4, 3],
      [0, 5],
    ]);
    const curve = bsplineCurve(3, knots, controlPoints);
    for (const r of [0, 1, 2]) {
      expect(distance(curve.derivative(0, r), curve.derivative(4, r))).toBeLessThan(1e-13);
    }
    expect(distance(curve.derivative(0, 3), curve.derivative(4, 3))).toBeGreaterThan(1);
  });

  test("outside the domain the end polynomials are continued", () => {
    const b = [[0], [1], [3], [2]];
    const curve = bsplineCurve(3, clampedKnots(3, 4), b);
    expect(curve.point(1.5)[0]).toBeCloseTo(bezierPoint(b, 1.5)[0]!, 13);
    expect(curve.point(-0.5)[0]).toBeCloseTo(bezierPoint(b, -0.5)[0]!, 13);
  });

  test("a step function and its derivative", () => {
    const step = bsplineCurve(0, [0, 1, 2], [[5], [7]]);
    expect([0, 0.5, 1, 2].map((t) => step.point(t)[0])).toEqual([5, 5, 7, 7]);
    expect(step.derivative(0.5)).toEqual([0]);
    expect(bsplineHodograph({ degree: 1, knots: [0, 0, 0.5, 1, 1], controlPoints: [[0], [1], [3]] })).toEqual(
      {
        degree: 0,
        knots: [0, 0.5, 1],
        controlPoints: [[2], [4]],
      },
    );
  });

  test("bad arguments are named", () => {
    expect(() => bsplineCurve(1, [0, 0, 1, 1], [])).toThrow(/^controlPoints: /);
    expect(() => bsplineCurve(1, [0, 0, 1], [[0], [1]])).toThrow(/^knots: /);
    expect(() => bsplineCurve(1, [0, 0, 1, 1], [[0], [1, 2]])).toThrow(/^controlPoints\[1\]: /);
  });
});

describe("knot insertion and Bézier pieces", () => {
  test("inserting a knot keeps the curve", () => {
    forAll([at, unit], ({ degree, knots, controlPoints, t }, u) => {
      const room = degree - multiplicity(knots, t);
      fc.pre(room > 0);
      const refined = insertKnot(degree, knots, controlPoints, t, room);
      expect(multiplicity(refined.knots, t)).toBe(degree);
      expect(refined.controlPoints.length).toBe(controlPoints.length + room);
      expect(refined.knots).toEqual([...refined.knots].sort((p, q) => p - q));
      const [a, b] = knotDomain(degree, knots);
      const s = Math.min(a + u * (b - a), b);
      const before = deBoor(degree, knots, controlPoints, s).levels[degree]![0]!;
      const sum = combine(bsplineBasis(degree, refined.knots, s), refined.controlPoints);
      expect(distance(before, sum)).toBeLessThan(1e-11 * size(controlPoints));
    });
  });

  test("each piece is the curve on its span", () => {
    forAll([spline, unit], ({ degree, knots, controlPoints }, u) => {
      const { breaks, segments } = bsplineToBezier(degree, knots, controlPoints);
      expect(breaks).toEqual(knotBreaks(degree, knots));
      expect(segments.length).toBe(breaks.length - 1);
      const curve = bsplineCurve(degree, knots, controlPoints);
      const misses = segments.map((segment, i) => {
        expect(segment.length).toBe(degree + 1);
        const t = breaks[i]! + Math.min(u, 0.999) * (breaks[i + 1]! - breaks[i]!);
        return distance(bezierPoint(segment, Math.min(u, 0.999)), curve.point(t));
      });
      expect(Math.max(...misses)).toBeLessThan(1e-11 * size(controlPoints));
    });
    expect(bsplineToBezier(0, [0, 1, 2], [[5], [7]])).toEqual({
      breaks: [0, 1, 2],
      segments: [[[5]], [[7]]],
    });
  });

  test("nothing to insert, nothing changed", () => {
    const d = [[0], [1], [2]];
    expect(insertKnot(2, [0, 0, 0, 1, 1, 1], d, 0.5, 0)).toEqual({
      degree: 2,
      knots: [0, 0, 0, 1, 1, 1],
      controlPoints: d,
    });
    expect(insertKnot(2, [0, 0, 0, 1, 1, 1], d, 1, 0).controlPoints).toEqual(d);
    expect(insertKnot(2, [-1, 0, 0.5, 1, 1.5, 2], d, 1).knots).toEqual([-1, 0, 0.5, 1, 1, 1.5, 2]);
  });

  test("bad arguments are named", () => {
    const [knots, d] = [
      [0, 0, 0, 1, 2, 2, 2],
      [[0], [1], [2], [3]],
    ];
    expect(() => insertKnot(2, knots, d, 2.5)).toThrow(
      "t: expected a parameter in the domain [0, 2], got 2.5",
    );
    expect(() => insertKnot(2, knots, d, -0.5)).toThrow(/^t: expected a parameter/);
    expect(() => insertKnot(2, knots, d, 1, 2)).toThrow(
      "times: expected at most 1, since 1 is a knot 1 times and the degree is 2, got 2",
    );
    expect(() => insertKnot(2, knots, d, 0, 1)).toThrow(
      "times: expected at most 0, since 0 is a knot 3 times and the degree is 2, got 1",
    );
    expect(() => insertKnot(2, knots, d, 1, 0.5)).toThrow(/^times: expected a whole number/);
    expect(() => insertKnot(2, knots, d, Number.NaN)).toThrow(/^t: /);
    expect(() => insertKnot(2, knots, [], 1)).toThrow(/^controlPoints: /);
    expect(() => insertKnot(2, [0, 1], d, 1)).toThrow(/^knots: /);
    expect(() => bsplineToBezier(2, knots, [])).toThrow(/^controlPoints: /);
    expect(() => bsplineToBezier(2, [0, 1], d)).toThrow(/^knots: /);
  });
});

describe("NURBS", () => {
  const weighted = at.chain((s) =>
    fc.tuple(
      fc.constant(s),
      fc.array(fc.double({ min: 0.1, max: 5, noNaN: true }), {
        minLength: s.controlPoints.length,
        maxLength: s.controlPoints.length,
      }),
    ),
  );

  test("the circle is exact, with unit tangents to it", () => {
    const circle = nurbsCurve(nurbsCircle([2, -1], 3));
    forAll([unit], (t) => {
      const p = circle.point(t);
      expect(distance(p, [2, -1])).toBeCloseTo(3, 13);
      const [x, y] = [p[0]! - 2, p[1]! + 1];
      const [dx, dy] = circle.derivative(t) as [number, number];
      expect(Math.abs(x * dx + y * dy)).toBeLessThan(1e-11);
      expect(x * dy - y * dx).toBeGreaterThan(1);
    });
    expect(
      [0, 0.25, 0.5, 0.75, 1].map((t) => circle.point(t).map((x) => Math.round(x * 1e12) / 1e12 + 0)),
    ).toEqual([
      [5, -1],
      [2, 2],
      [-1, -1],
      [2, -4],
      [5, -1],
    ]);
    expect(circle.breaks).toEqual([0.25, 0.5, 0.75]);
    expect([circle.domain, circle.dimension]).toEqual([[0, 1], 2]);
    expect(nurbsCircle()).toMatchObject({ degree: 2 });
    expect(nurbsCurve(nurbsCircle()).point(0)).toEqual([1, 0]);
  });

  test("is Σ w_i d_i N_i / Σ w_i N_i; its derivatives are limits of differences", () => {
    forAll([weighted], ([{ t, ...data }, weights]) => {
      const nurbs = { ...data, weights };
      const basis = bsplineBasis(data.degree, data.knots, t).map((n, i) => n * weights[i]!);
      const sum = basis.reduce((s, x) => s + x, 0);
      const wanted = combine(
        basis.map((x) => x / sum),
        data.controlPoints,
      );
      expect(distance(nurbsDerivative(nurbs, t)!, wanted)).toBeLessThan(1e-11 * size(data.controlPoints));
      const breaks = knotBreaks(data.degree, data.knots);
      fc.pre(breaks.every((knot) => Math.abs(knot - t) > 1e-3));
      const e = 1e-5;
      for (const r of [1, 2]) {
        const before = nurbsDerivative(nurbs, t - e, r - 1)!;
        const numeric = nurbsDerivative(nurbs, t + e, r - 1)!.map((x, i) => (x - before[i]!) / (2 * e));
        const exact = nurbsDerivative(nurbs, t, r)!;
        expect(distance(numeric, exact)).toBeLessThan(0.02 * size([exact, ...data.controlPoints]));
      }
    });
  });

  test("equal weights change nothing; the curve is that of its rational Bézier pieces", () => {
    forAll([weighted, unit], ([{ t, ...data }, weights], u) => {
      const equal = nurbsCurve({ ...data, weights: weights.map(() => 2.5) });
      const plain = bsplineCurve(data.degree, data.knots, data.controlPoints);
      expect(distance(equal.point(t), plain.point(t))).toBeLessThan(1e-12 * size(data.controlPoints));
      const curve = nurbsCurve({ ...data, weights });
      const { breaks, segments } = nurbsToBezier({ ...data, weights });
      const s = Math.min(u, 0.999);
      const misses = segments.map((piece, i) => {
        const wanted = curve.point(breaks[i]! + s * (breaks[i + 1]! - breaks[i]!));
        return distance(rationalBezierPoint(piece.controlPoints, piece.weights, s)!, wanted);
      });
      expect(Math.max(...misses)).toBeLessThan(1e-10 * size(data.controlPoints));
    });
  });

  test("a pole has no value; a tiny weight beside no other does", () => {
    const pole = {
      degree: 2,
      knots: [0, 0, 0, 1, 1, 1],
      controlPoints: [
        [0, 0],
        [1, 2],
        [3, 0],
      ],
      weights: [1, -1, 1],
    };
    expect(nurbsDerivative(pole, 0.5)).toBeNull();
    expect(nurbsDerivative(pole, 0.5, 1)).toBeNull();
    expect(nurbsDerivative(pole, 0.25)).not.toBeNull();
    expect(nurbsDerivative({ ...pole, weights: [1e-200, 1e-200, 1e-200] }, 0.5)![0]).toBeCloseTo(1.25, 12);
    expect(nurbsDerivative({ ...pole, weights: [-1, -1, -1] }, 0.5)![0]).toBeCloseTo(1.25, 12);
  });

  test("bad arguments are named", () => {
    const good = nurbsCircle();
    expect(() => nurbsDerivative(good, Number.NaN)).toThrow(/^t: /);
    expect(() => nurbsDerivative(good, 0, -1)).toThrow(/^r: /);
    expect(() => nurbsDerivative({ ...good, weights: [1] }, 0)).toThrow(/^weights: expected 9 weights/);
    expect(() => nurbsDerivative({ ...good, weights: good.weights.map(() => 0) }, 0)).toThrow(
      /^weights: expected at least one/,
    );
    expect(() => nurbsDerivative({ ...good, knots: [0, 1] }, 0)).toThrow(/^knots: /);
    expect(() => nurbsCurve({ ...good, weights: good.weights.map((w, i) => (i === 3 ? -w : w)) })).toThrow(
      /^weights\[3\]: expected a positive finite number/,
    );
    expect(() => nurbsToBezier({ ...good, weights: good.weights.map((w, i) => (i === 3 ? 0 : w)) })).toThrow(
      /^weights\[3\]: /,
    );
    expect(() => nurbsToBezier({ ...good, weights: [1] })).toThrow(/^weights: /);
    expect(() => nurbsCircle([0, 0, 0])).toThrow(/^centre\[0\]: /);
    expect(() => nurbsCircle([0, 0], 0)).toThrow(/^radius: /);
  });
});
