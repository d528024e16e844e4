import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  add,
  bendingEnergy,
  bezierPoint,
  type CubicSpline,
  cubicSpline,
  cubicSplineTangents,
  distance,
  findInterval,
  hermiteSpline,
  norm,
  type Point,
  parametrizations,
  parametrize,
  type SplineEnd,
  scale,
  segmentMoments,
  solveCyclic,
  solveTridiagonal,
  splineSystem,
  splineToBezier,
  sub,
  type TridiagonalSystem,
} from "../../src/math/index.ts";
import { forAll, point, size } from "./property.ts";

const step = fc.integer({ min: 1, max: 12 }).map((k) => k / 4);
/** Ascending nodes with as many points in the plane. */
const data = fc.array(step, { minLength: 1, maxLength: 8 }).chain((steps) => {
  const nodes = [-2];
  for (const h of steps) nodes.push(nodes.at(-1)! + h);
  return fc.tuple(
    fc.constant(nodes),
    fc.array(point(2), { minLength: nodes.length, maxLength: nodes.length }),
  );
});
const ends: fc.Arbitrary<SplineEnd> = fc.oneof(
  fc.constant<SplineEnd>({ type: "natural" }),
  fc.constant<SplineEnd>({ type: "notAKnot" }),
  fc.constant<SplineEnd>({ type: "periodic" }),
  fc.tuple(point(2), point(2)).map(([start, end]): SplineEnd => ({ type: "clamped", start, end })),
);
const close = (points: readonly Point[], { type }: SplineEnd): Point[] =>
  type === "periodic" ? [...points.slice(0, -1), points[0]!] : [...points];

/** The derivative of order r at a node, from the left and from the right: from the Bézier forms of both segments. */
function sides(spline: CubicSpline, i: number, r: number): [Point, Point] {
  const side = (segment: number, u: number): Point => {
    const h = spline.nodes[segment + 1]! - spline.nodes[segment]!;
    let legs: Point[] = splineToBezier(spline)[segment]!;
    for (let k = 0; k < r; k++) legs = legs.slice(1).map((p, j) => scale(sub(p, legs[j]!), (3 - k) / h));
    return bezierPoint(legs, u);
  };
  return [side(i - 1, 1), side(i, 0)];
}

describe("tridiagonal systems", () => {
  const entry = fc.double({ min: -1, max: 1, noNaN: true });
  const system = fc.integer({ min: 1, max: 9 }).chain((n) => {
    const list = fc.array(entry, { minLength: n, maxLength: n });
    return fc.tuple(list, list, fc.array(point(2), { minLength: n, maxLength: n }), fc.boolean());
  });
  const make = ([below, above, right, negative]: [
    number[],
    number[],
    Point[],
    boolean,
  ]): TridiagonalSystem => {
    // Diagonally dominant, so that there is one solution.
    const diagonal = below.map((b, i) => (negative ? -1 : 1) * (Math.abs(b) + Math.abs(above[i]!) + 0.5));
    return { below, diagonal, above, right };
  };
  const residual = ({ below, diagonal, above, right }: TridiagonalSystem, x: Point[], cyclic: boolean) => {
    const n = x.length;
    const at = (i: number): Point => (cyclic ? x[(i + n) % n]! : (x[i] ?? [0, 0]));
    const misses = right.map((b, r) => {
      const left = add(
        scale(at(r - 1), below[r]!),
        add(scale(at(r), diagonal[r]!), scale(at(r + 1), above[r]!)),
      );
      return distance(left, b);
    });
    return Math.max(...misses);
  };

  test("the solution satisfies every equation", () => {
    forAll([system], (parts) => {
      const s = make(parts);
      expect(residual(s, solveTridiagonal(s), false)).toBeLessThan(1e-11 * size(s.right));
    });
  });

  test("cyclic: the corners couple the first and the last unknown", () => {
    forAll([system], (parts) => {
      const s = make(parts);
      expect(residual(s, solveCyclic(s), true)).toBeLessThan(1e-10 * size(s.right));
    });
  });

  test("cyclic systems of one and of two unknowns are their own neighbours", () => {
    expect(solveCyclic({ below: [1], diagonal: [5], above: [2], right: [[16]] })).toEqual([[2]]);
    const two = { below: [1, 2], diagonal: [5, 7], above: [1, 1], right: [[9], [17]] };
    expect(solveCyclic(two)).toEqual([[expect.closeTo(1, 14)], [expect.closeTo(2, 14)]]);
  });

  test("the caller's lists stay as they are", () => {
    const s = { below: [0, 1], diagonal: [2, 4], above: [1, 0], right: [[1], [2]] };
    expect(solveTridiagonal(s)).toEqual([[2 / 7], [3 / 7]].map(([x]) => [expect.closeTo(x!, 15)]));
    expect(s).toEqual({ below: [0, 1], diagonal: [2, 4], above: [1, 0], right: [[1], [2]] });
  });
});

describe("the spline's system", () => {
  test("uniform: m_{r−1} + 4m_r + m_{r+1} = 3(P_{r+1} − P_{r−1})", () => {
    const points = [[0], [1], [4], [2]];
    const natural = splineSystem([0, 1, 2, 3], points, { type: "natural" });
    expect(natural).toEqual({
      below: [0, 1, 1, 1],
      diagonal: [2, 4, 4, 2],
      above: [1, 1, 1, 0],
      right: [[3], [12], [3], [-6]],
    });
    const clamped = splineSystem([0, 1, 2, 3], points, { type: "clamped", start: [7], end: [8] });
    expect(clamped.diagonal).toEqual([1, 4, 4, 1]);
    expect(clamped.above).toEqual([0, 1, 1, 0]);
    expect(clamped.below).toEqual([0, 1, 1, 0]);
    expect([clamped.right[0], clamped.right[3]]).toEqual([[7], [8]]);
    const periodic = splineSystem([0, 1, 2, 3], [[0], [1], [4], [0]], { type: "periodic" });
    expect(periodic).toEqual({
      below: [1, 1, 1],
      diagonal: [4, 4, 4],
      above: [1, 1, 1],
      right: [[-9], [12], [-3]],
    });
  });

  test("bad arguments are named", () => {
    const natural: SplineEnd = { type: "natural" };
    expect(() => splineSystem([0], [[1]], natural)).toThrow("nodes: expected at least 2 numbers, got 1");
    expect(() => splineSystem([0, 0], [[1], [2]], natural)).toThrow(/^nodes\[1\]: expected a number greater/);
    expect(() => splineSystem([0, 1], [[1]], natural)).toThrow(
      "points: expected 2 entries, one for each of nodes, got 1",
    );
    expect(() => splineSystem([0, 1], [[1], [Number.NaN]], natural)).toThrow(/^points\[1\]\[0\]: /);
    expect(() => splineSystem([0, 1], [[1], [2]], { type: "clamped", start: [1, 2], end: [1] })).toThrow(
      /^end\.start: /,
    );
    expect(() => splineSystem([0, 1], [[1], [2]], { type: "clamped", start: [1], end: [] })).toThrow(
      /^end\.end: /,
    );
    expect(() =>
      splineSystem(
        [0, 1],
        [
          [1, 2],
          [1, 3],
        ],
        { type: "periodic" },
      ),
    ).toThrow("points[1][1]: expected 2 as in points[0], since the spline is periodic, got 3");
    expect(() =>
      splineSystem(
        [0, 1],
        [
          [1, 2],
          [4, 2],
        ],
        { type: "periodic" },
      ),
    ).toThrow("points[1][0]: expected 1 as in points[0], since the spline is periodic, got 4");
    expect(() => splineSystem([0, 1], [[1], [2]], { type: "free" } as never)).toThrow(
      'end.type: expected clamped, natural, notAKnot or periodic, got "free"',
    );
  });
});

describe("the cubic spline", () => {
  test("meets the points and is C² at every inner node", () => {
    forAll([data, ends], ([nodes, raw], end) => {
      const points = close(raw, end);
      const spline = cubicSpline(nodes, points, end);
      expect(nodes.map((t) => spline.point(t).map((x) => x + 0))).toEqual(
        points.map((p) => p.map((x) => x + 0)),
      );
      for (let i = 1; i + 1 < nodes.length; i++) {
        for (const r of [0, 1, 2]) {
          const [left, right] = sides(spline, i, r);
          expect(distance(left, right)).toBeLessThan(1e-8 * size(points));
        }
      }
      expect(cubicSplineTangents(nodes, points, end)).toEqual(spline.tangents);
      expect(spline.end).toBe(end);
    });
  });

  test("keeps its end condition", () => {
    forAll([data, ends], ([nodes, raw], end) => {
      const points = close(raw, end);
      const spline = cubicSpline(nodes, points, end);
      const n = nodes.length - 1;
      const tolerance = 1e-8 * size(points);
      const [first] = segmentMoments(spline, 0);
      const [, last] = segmentMoments(spline, n - 1);
      if (end.type === "natural") {
        expect(norm(first) + norm(last)).toBeLessThan(tolerance);
      } else if (end.type === "clamped") {
        expect(distance(spline.tangents[0]!, end.start)).toBeLessThan(tolerance);
        expect(distance(spline.tangents[n]!, end.end)).toBeLessThan(tolerance);
      } else if (end.type === "periodic") {
        expect(spline.tangents[n]).toEqual(spline.tangents[0]);
        expect(distance(first, last)).toBeLessThan(tolerance);
      } else if (n > 1) {
        for (const i of [1, n - 1]) {
          const [left, right] = sides(spline, i, 3);
          expect(distance(left, right)).toBeLessThan(100 * tolerance);
        }
      }
    });
  });

  test("reproduces what it should: lines (natural), cubics (clamped, not-a-knot)", () => {
    const f = (x: number) => 1 - 2 * x + x ** 2 - 0.5 * x ** 3;
    const slope = (x: number) => -2 + 2 * x - 1.5 * x ** 2;
    const nodes = [-1, 0, 0.5, 2, 3];
    const points = nodes.map((x) => [f(x)]);
    const clamped = cubicSpline(nodes, points, { type: "clamped", start: [slope(-1)], end: [slope(3)] });
    const notAKnot = cubicSpline(nodes, points, { type: "notAKnot" });
    const line = cubicSpline(
      nodes,
      nodes.map((x) => [2 * x - 1]),
      { type: "natural" },
    );
    for (const x of [-1, -0.3, 0.2, 1.1, 2.9]) {
      expect(clamped.point(x)[0]).toBeCloseTo(f(x), 12);
      expect(notAKnot.point(x)[0]).toBeCloseTo(f(x), 12);
      expect(line.point(x)[0]).toBeCloseTo(2 * x - 1, 13);
      expect(line.derivative(x, 2)[0]).toBeCloseTo(0, 12);
    }
  });

  test("few points: the line and the parabola", () => {
    for (const type of ["natural", "notAKnot"] as const) {
      expect(cubicSpline([1, 3], [[2], [8]], { type }).point(1.5)[0]).toBeCloseTo(3.5, 14);
    }
    const parabola = cubicSpline([0, 1, 3], [[0], [1], [9]], { type: "notAKnot" });
    expect(parabola.point(2)[0]).toBeCloseTo(4, 13);
    expect(cubicSpline([0, 2], [[5], [5]], { type: "periodic" }).point(1)).toEqual([5]);
  });

  test("the natural spline has the least ∫(S″)² among interpolating splines", () => {
    forAll([data, point(2), point(2)], ([nodes, points], start, end) => {
      const natural = bendingEnergy(cubicSpline(nodes, points, { type: "natural" }));
      const clamped = bendingEnergy(cubicSpline(nodes, points, { type: "clamped", start, end }));
      expect(natural).toBeLessThanOrEqual(clamped * (1 + 1e-9) + 1e-9 * size(points) ** 2);
    });
  });

  test("the energy is the integral of the squared second derivative", () => {
    const spline = cubicSpline([0, 1, 3], [[0], [2], [1]], { type: "natural" });
    const n = 20_000;
    let sum = 0;
    for (let k = 0; k < n; k++) sum += (3 / n) * spline.derivative((3 * (k + 0.5)) / n, 2)[0]! ** 2;
    expect(bendingEnergy(spline)).toBeCloseTo(sum, 6);
    expect(bendingEnergy(cubicSpline([0, 1, 5], [[0], [2], [10]], { type: "natural" }))).toBeCloseTo(0, 20);
  });

  test("the influence of one point fades by √3 − 2 per node", () => {
    const nodes = Array.from({ length: 31 }, (_, i) => i);
    const bump = nodes.map((i) => [i === 15 ? 1 : 0]);
    const m = cubicSplineTangents(nodes, bump, { type: "natural" }).map(([x]) => x!);
    for (let i = 16; i < 22; i++) expect(m[i + 1]! / m[i]!).toBeCloseTo(Math.sqrt(3) - 2, 4);
    const moved = cubicSpline(
      nodes.slice(0, 13),
      nodes.slice(0, 13).map((i) => [i === 2 ? 1 : 0]),
      { type: "natural" },
    );
    const samples = Array.from({ length: 101 }, (_, k) => Math.abs(moved.point(6 + k / 100)[0]!));
    expect(Math.max(...samples)).toBeCloseTo(0.0026, 4);
  });

  test("Runge's function on 15 nodes: error 0.0025", () => {
    const nodes = Array.from({ length: 15 }, (_, i) => -5 + (10 * i) / 14);
    const spline = cubicSpline(
      nodes,
      nodes.map((x) => [1 / (1 + x * x)]),
      { type: "natural" },
    );
    const errors = Array.from({ length: 2001 }, (_, k) => {
      const x = -5 + k / 200;
      return Math.abs(spline.point(x)[0]! - 1 / (1 + x * x));
    });
    expect(Math.max(...errors)).toBeCloseTo(0.0025, 4);
  });

  test("a million points in linear time and without recursion", () => {
    const build = (n: number, type: "natural" | "periodic") => {
      const nodes = Array.from({ length: n }, (_, i) => i);
      const points = nodes.map((i) => [Math.sin(i / 100)]);
      points[n - 1] = [0];
      return cubicSpline(nodes, points, { type });
    };
    expect(build(1_000_000, "natural").point(123_456.5)[0]).toBeCloseTo(Math.sin(1234.565), 6);
    expect(build(200_000, "periodic").point(123_456.5)[0]).toBeCloseTo(Math.sin(1234.565), 6);
  }, 60_000);
});

describe("the Hermite spline", () => {
  const spline = hermiteSpline(
    [0, 2, 3],
    [
      [0, 0],
      [4, 2],
      [5, 0],
    ],
    [
      [1, 1],
      [0, 2],
      [3, 0],
    ],
  );

  test("meets points and tangents; takes derivatives from the right, at the end from the left", () => {
    expect([0, 2, 3].map((t) => spline.point(t))).toEqual([
      [0, 0],
      [4, 2],
      [5, 0],
    ]);
    [0, 2, 3].forEach((t, i) => {
      expect(distance(spline.derivative(t), spline.tangents[i]!)).toBeLessThan(1e-14);
    });
    const moments = [segmentMoments(spline, 1)[0], segmentMoments(spline, 1)[1]];
    expect(distance(spline.derivative(2, 2), moments[0]!)).toBeLessThan(1e-13);
    expect(distance(spline.derivative(3, 2), moments[1]!)).toBeLessThan(1e-13);
    expect(distance(spline.derivative(0, 2), segmentMoments(spline, 0)[0])).toBeLessThan(1e-13);
    expect(spline.derivative(1, 4)).toEqual([0, 0]);
    const e = 1e-5;
    const third = scale(sub(spline.derivative(1 + e, 2), spline.derivative(1 - e, 2)), 1 / (2 * e));
    expect(distance(third, spline.derivative(1, 3))).toBeLessThan(1e-6);
  });

  test("its Bézier pieces are the same curve", () => {
    const pieces = splineToBezier(spline);
    expect(pieces.length).toBe(2);
    for (const u of [0, 0.3, 1]) {
      expect(distance(bezierPoint(pieces[0]!, u), spline.point(2 * u))).toBeLessThan(1e-14);
      expect(distance(bezierPoint(pieces[1]!, u), spline.point(2 + u))).toBeLessThan(1e-14);
    }
  });

  test("is a curve: domain, breaks, a bound for its speed, pieces", () => {
    expect(spline.domain).toEqual([0, 3]);
    expect(spline.breaks).toEqual([2]);
    expect(spline.dimension).toBe(2);
    forAll([data], ([nodes, points]) => {
      const s = cubicSpline(nodes, points, { type: "natural" });
      const [a, b] = s.domain;
      const speeds = Array.from({ length: 21 }, (_, k) => norm(s.derivative(a + ((b - a) * k) / 20)));
      expect(Math.max(...speeds)).toBeLessThanOrEqual(s.speed! * (1 + 1e-12));
    });
    // Exactly the longest leg of the hodographs: tangents (1,1), (0,2), (3,0), inner legs (5,0) and (0,−8).
    expect(spline.speed).toBe(8);
    expect(hermiteSpline([0, 1], [[0], [1]], [[9], [1]]).speed).toBe(9);
    expect(hermiteSpline([0, 1], [[0], [1]], [[1], [9]]).speed).toBe(9);
    const [left, right] = spline.split!(1);
    expect([left.domain, left.breaks]).toEqual([[0, 1], []]);
    expect([right.domain, right.breaks]).toEqual([[1, 3], [2]]);
    expect(right.split!(2).map(({ breaks }) => breaks)).toEqual([[], []]);
    expect(right.point(1.7)).toEqual(spline.point(1.7));
    expect(left.derivative(0.7, 2)).toEqual(spline.derivative(0.7, 2));
  });

  test("is local: a tangent acts on its two segments only", () => {
    const nodes = [0, 1, 2, 3, 4];
    const points = nodes.map((t) => [t, 0]);
    const flat = hermiteSpline(
      nodes,
      points,
      nodes.map(() => [1, 0]),
    );
    const bent = hermiteSpline(
      nodes,
      points,
      nodes.map((t) => [1, t === 2 ? 1 : 0]),
    );
    for (const t of [0.5, 3.5]) expect(bent.point(t)).toEqual(flat.point(t));
    for (const t of [1.5, 2.5]) expect(bent.point(t)).not.toEqual(flat.point(t));
  });

  test("bad arguments are named", () => {
    const p: Point[] = [[0], [1]];
    expect(() => hermiteSpline([0], [[0]], [[0]])).toThrow(/^nodes: expected at least 2 numbers/);
    expect(() => hermiteSpline([1, 0], p, p)).toThrow(/^nodes\[1\]: /);
    expect(() => hermiteSpline([0, 1], [[0], [1, 2]], p)).toThrow(/^points\[1\]: /);
    expect(() => hermiteSpline([0, 1], p, [[0], [1, 2]])).toThrow(/^tangents\[1\]: /);
    expect(() => hermiteSpline([0, 1, 2], p, p)).toThrow(
      "points: expected 3 entries, one for each of nodes, got 2",
    );
    expect(() => hermiteSpline([0, 1], p, [[0]])).toThrow(
      "tangents: expected 2 entries, one for each of nodes, got 1",
    );
  });
});

describe("parametrisation and search", () => {
  test("uniform, centripetal and chordal nodes", () => {
    const points = [
      [0, 0],
      [3, 4],
      [3, 13],
    ];
    expect(parametrize(points, parametrizations.uniform)).toEqual([0, 1, 2]);
    expect(parametrize(points, parametrizations.chordal)).toEqual([0, 5, 14]);
    expect(parametrize(points, parametrizations.centripetal)).toEqual([0, Math.sqrt(5), Math.sqrt(5) + 3]);
    expect(parametrize([[1], [1]], 0)).toEqual([0, 1]);
  });

  test("bad arguments are named", () => {
    expect(() => parametrize([], 0)).toThrow(/^points: /);
    expect(() => parametrize([[0]], Number.NaN)).toThrow(/^alpha: /);
    expect(() => parametrize([[0]], -0.1)).toThrow("alpha: expected a number from 0 to 1, got -0.1");
    expect(() => parametrize([[0]], 1.1)).toThrow("alpha: expected a number from 0 to 1, got 1.1");
    expect(() =>
      parametrize(
        [
          [0, 1],
          [2, 3],
          [2, 3],
        ],
        0.5,
      ),
    ).toThrow(
      "points[2]: expected a point apart from points[1], got [2,3]; only the uniform parametrisation allows both at one place",
    );
  });

  test("findInterval finds the interval that holds t", () => {
    const nodes = [0, 1, 1.5, 4, 9];
    expect([-1, 0, 0.9, 1, 1.2, 1.5, 3, 4, 8, 9, 99].map((t) => findInterval(nodes, t))).toEqual([
      0, 0, 0, 1, 1, 2, 2, 3, 3, 3, 3,
    ]);
    expect(findInterval([0, 1], 0.5)).toBe(0);
  });
});
