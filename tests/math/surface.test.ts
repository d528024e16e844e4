import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  bernsteinAll,
  bezierCurve,
  bezierPatch,
  bezierPoint,
  bsplineBasis,
  bsplineSurface,
  bsplineSurfaceToPatches,
  type ControlNet,
  clampedKnots,
  combine,
  cross,
  distance,
  dot,
  fundamentalForms,
  graphSurface,
  isCollapsed,
  isoCurve,
  knotBreaks,
  limitNormal,
  norm,
  normalize,
  type Point,
  patchIsoCurve,
  patchPartial,
  patchPoint,
  revolvedSurface,
  ruledSurface,
  type Surface,
  scale,
  sphereSurface,
  sub,
  surfaceCurvature,
  surfaceNormal,
} from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

const netOf = (m: number, n: number) =>
  fc.array(fc.array(point(3), { minLength: n + 1, maxLength: n + 1 }), {
    minLength: m + 1,
    maxLength: m + 1,
  });
const net = fc
  .tuple(fc.integer({ min: 0, max: 4 }), fc.integer({ min: 0, max: 4 }))
  .chain(([m, n]) => netOf(m, n));

const bicubic: ControlNet = [
  [
    [0, 0, 0],
    [0, 1, 1],
    [0, 2, 1],
    [0, 3, 0],
  ],
  [
    [1, 0, 1],
    [1, 1, 3],
    [1, 2, 2],
    [1, 3, 1],
  ],
  [
    [2, 0, 1],
    [2, 1, 2],
    [2, 2, -1],
    [2, 3, 1],
  ],
  [
    [3, 0, 0],
    [3, 1, 1],
    [3, 2, 1],
    [3, 3, 2],
  ],
];

/** The partial derivative of order (k, l) by central differences of the next lower one. */
function numeric(surface: Surface, u: number, v: number, k: number, l: number): Point {
  const e = 1e-5;
  return k > 0
    ? scale(sub(surface.partial(u + e, v, k - 1, l), surface.partial(u - e, v, k - 1, l)), 1 / (2 * e))
    : scale(sub(surface.partial(u, v + e, k, l - 1), surface.partial(u, v - e, k, l - 1)), 1 / (2 * e));
}
const orders = [
  [1, 0],
  [0, 1],
  [2, 0],
  [1, 1],
  [0, 2],
  [2, 1],
  [3, 3],
] as const;

describe("Bézier patches", () => {
  test("S = Σ Σ c_ij·B_i·B_j, at the corners the corner points", () => {
    forAll([net, unit, unit], (c, u, v) => {
      const [bu, bv] = [bernsteinAll(c.length - 1, u), bernsteinAll(c[0]!.length - 1, v)];
      const wanted = combine(
        bu,
        c.map((row) => combine(bv, row)),
      );
      const s = size(c.flat());
      expect(distance(patchPoint(c, u, v), wanted)).toBeLessThan(1e-13 * s);
      expect(bezierPatch(c).point(u, v)).toEqual(patchPoint(c, u, v));
      expect(distance(patchPoint(c, 0, 1), c[0]!.at(-1)!)).toBe(0);
      expect(distance(patchPoint(c, 1, 0), c.at(-1)![0]!)).toBe(0);
    });
  });

  test("partial derivatives of any order", () => {
    const patch = bezierPatch(bicubic);
    forAll([unit, unit], (u, v) => {
      const misses = orders.map(([k, l]) => distance(patch.partial(u, v, k, l), numeric(patch, u, v, k, l)));
      expect(Math.max(...misses)).toBeLessThan(1e-4);
    });
    expect(patchPartial(bicubic, 0.5, 0.5, 4, 0)).toEqual([0, 0, 0]);
    expect(patchPartial(bicubic, 0.2, 0.7, 0, 0)).toEqual(patchPoint(bicubic, 0.2, 0.7));
  });

  test("iso-parametric curves", () => {
    forAll([net, unit, unit], (c, u, v) => {
      const wanted = patchPoint(c, u, v);
      const tolerance = 1e-12 * size(c.flat());
      expect(distance(bezierPoint(patchIsoCurve(c, "u", u), v), wanted)).toBeLessThan(tolerance);
      expect(distance(bezierPoint(patchIsoCurve(c, "v", v), u), wanted)).toBeLessThan(tolerance);
      const patch = bezierPatch(c);
      expect(isoCurve(patch, "u", u).point(v)).toEqual(wanted);
      expect(isoCurve(patch, "v", v).point(u)).toEqual(wanted);
      expect(isoCurve(patch, "u", u).derivative(v)).toEqual(patch.partial(u, v, 0, 1));
      expect(isoCurve(patch, "v", v).derivative(u, 2)).toEqual(patch.partial(u, v, 2, 0));
    });
    const sphere = sphereSurface();
    expect(isoCurve(sphere, "u", 0).domain).toEqual(sphere.domain[1]);
    expect(isoCurve(sphere, "v", 0).domain).toEqual(sphere.domain[0]);
    expect(isoCurve(sphere, "v", 0).dimension).toBe(3);
  });

  test("the speed bounds both tangents and is a leg of the net", () => {
    forAll([net, unit, unit], (c, u, v) => {
      const patch = bezierPatch(c);
      const longest = Math.max(norm(patch.partial(u, v, 1, 0)), norm(patch.partial(u, v, 0, 1)));
      expect(longest).toBeLessThanOrEqual(patch.speed! * (1 + 1e-12));
    });
    expect(
      bezierPatch([
        [[0], [1]],
        [[5], [6]],
      ]).speed,
    ).toBe(5);
    expect(
      bezierPatch([
        [[0], [5]],
        [[1], [6]],
      ]).speed,
    ).toBe(5);
    expect(bezierPatch([[[0], [5], [5]]]).speed).toBe(10);
    expect(bezierPatch([[[7]]]).speed).toBe(0);
    expect(
      bezierPatch([
        [[0], [5]],
        [[1], [6]],
      ]).dimension,
    ).toBe(1);
  });

  test("bad nets are named", () => {
    expect(() => bezierPatch([])).toThrow("controlPoints: expected at least 1 row, got none");
    expect(() => bezierPatch([[]])).toThrow(/^controlPoints\[0\]: expected at least 1 point/);
    expect(() => bezierPatch([[[0], [1]], [[0]]])).toThrow(
      "controlPoints[1]: expected 2 points as in the first row, got 1",
    );
    expect(() =>
      bezierPatch([
        [[0], [1]],
        [[0], [1, 2]],
      ]),
    ).toThrow(/^controlPoints\[1\]\[1\]: expected 1 coordinate/);
    expect(() => bezierPatch([[[0]], [[Number.NaN]]])).toThrow(/^controlPoints\[1\]\[0\]\[0\]: /);
    expect(() => patchPoint([], 0, 0)).toThrow(/^controlPoints: /);
    expect(() => patchPartial([], 0, 0, 1, 0)).toThrow(/^controlPoints: /);
    expect(() => patchPartial(bicubic, 0, 0, -1, 0)).toThrow(/^k: /);
    expect(() => patchPartial(bicubic, 0, 0, 0, 0.5)).toThrow(/^l: /);
    expect(() => patchPartial(bicubic, 0, Number.NaN, 0, 0)).toThrow(/^v: /);
    expect(() => patchPartial(bicubic, Number.NaN, 0, 0, 0)).toThrow(/^u: /);
    expect(() => patchPoint(bicubic, Number.NaN, 0)).toThrow(/^u: /);
    expect(() => patchPoint(bicubic, 0, Number.NaN)).toThrow(/^v: /);
    expect(() => patchIsoCurve([], "u", 0)).toThrow(/^controlPoints: /);
    expect(() => patchIsoCurve(bicubic, "u", Number.NaN)).toThrow(/^value: /);
    expect(() => bezierPatch("net" as unknown as ControlNet)).toThrow(
      /^controlPoints: expected at least 1 row/,
    );
  });
});

describe("normals", () => {
  test("are unit vectors, orthogonal to both tangents, in the direction of S_u × S_v", () => {
    forAll([netOf(3, 2), unit, unit], (c, u, v) => {
      const patch = bezierPatch(c);
      const n = surfaceNormal(patch, u, v);
      fc.pre(n !== null);
      const [su, sv] = [patch.partial(u, v, 1, 0), patch.partial(u, v, 0, 1)];
      expect(norm(n!)).toBeCloseTo(1, 13);
      expect(Math.abs(dot(n!, su)) / norm(su)).toBeLessThan(1e-5);
      expect(Math.abs(dot(n!, sv)) / norm(sv)).toBeLessThan(1e-5);
      expect(dot(n!, cross(su, sv))).toBeGreaterThan(0);
    });
  });

  test("do not exist where tangents vanish or are parallel, however far from the origin or small the patch", () => {
    for (const [factor, shift] of [
      [1, 0],
      [1e-8, 0],
      [1e8, 0],
      [1, 1e4],
    ] as const) {
      const move = (p: Point): Point => p.map((x) => factor * x + shift);
      const fold: ControlNet = [
        [
          [0, 0, 0],
          [1, 0, 0],
        ],
        [
          [2, 0, 0],
          [2, 2, 1],
        ],
      ].map((row) => row.map(move));
      expect(surfaceNormal(bezierPatch(fold), 0, 0)).toBeNull();
      expect(limitNormal(bezierPatch(fold), 0, 0)).toBeNull();
      expect(surfaceNormal(bezierPatch(fold), 1e-6, 0)).not.toBeNull();
      const tip: ControlNet = [
        [
          [0, 0, 0.1],
          [0, 0, 0.1],
        ],
        [
          [1, 0, 0],
          [0, 1, 0],
        ],
      ].map((row) => row.map(move));
      expect(surfaceNormal(bezierPatch(tip), 0, 0.5)).toBeNull();
      expect(surfaceNormal(bezierPatch(tip), 1e-6, 0.5)).not.toBeNull();
      expect(limitNormal(bezierPatch(tip), 0, 0.5)).not.toBeNull();
    }
    expect(surfaceNormal(bezierPatch([[[1, 2, 3]]]), 0, 0)).toBeNull();
    expect(limitNormal(bezierPatch([[[1, 2, 3]]]), 0, 0)).toBeNull();
    expect(
      limitNormal(
        bezierPatch([
          [
            [0, 0, 0],
            [1, 1, 1],
          ],
          [
            [1, 1, 1],
            [2, 2, 2],
          ],
        ]),
        0,
        0,
      ),
    ).toBeNull();
  });

  /** A net whose edge is collapsed: the lines fan out from one point. */
  const collapsed = (edge: "u0" | "u1" | "v0" | "v1"): ControlNet => {
    const rows = bicubic.map((row, i) => (i === 0 ? row.map(() => [0, 1, 0]) : row));
    const turned = edge.endsWith("1") ? [...rows].reverse() : rows;
    return edge.startsWith("u") ? turned : turned[0]!.map((_, j) => turned.map((row) => row[j]!));
  };

  test.each(["u0", "u1", "v0", "v1"] as const)(
    "on the collapsed edge %s the limit is approached from inside",
    (edge) => {
      const patch = bezierPatch(collapsed(edge));
      for (const s of [0, 0.3, 0.5, 1]) {
        const value = edge.endsWith("1") ? 1 : 0;
        const near = edge.endsWith("1") ? 1 - 1e-6 : 1e-6;
        const [u, v] = edge.startsWith("u") ? [value, s] : [s, value];
        const [nu, nv] = edge.startsWith("u") ? [near, s] : [s, near];
        expect(surfaceNormal(patch, u, v)).toBeNull();
        expect(distance(limitNormal(patch, u, v)!, surfaceNormal(patch, nu, nv)!)).toBeLessThan(1e-4);
      }
      expect(limitNormal(patch, 0.5, 0.5)).toEqual(surfaceNormal(patch, 0.5, 0.5));
      const inside = edge.startsWith("u") ? [0.5, 0] : [0, 0.5];
      expect(limitNormal(patch, inside[0]!, inside[1]!)).toEqual(
        surfaceNormal(patch, inside[0]!, inside[1]!),
      );
    },
  );

  test("tips of higher order: two and four rows in one point, up to rounding", () => {
    const quintic: ControlNet = Array.from({ length: 6 }, (_, i) =>
      Array.from({ length: 3 }, (_, j) => [i, (j - 1) * i + 0.3 * j, i * i * 0.2 + Math.cos(3 * j + i)]),
    );
    for (const [base, rows, distanceInside] of [
      [bicubic, 2, 1e-4],
      [quintic, 4, 1e-3],
    ] as const) {
      for (const noise of [0, 1e-15]) {
        const tipped = base.map((row, i) =>
          i < rows ? row.map((_, j) => [noise * (j - i), 1, noise * i * j]) : row,
        );
        for (const turn of [false, true]) {
          const patch = bezierPatch(turn ? [...tipped].reverse() : tipped);
          const [end, near] = turn ? [1, 1 - distanceInside] : [0, distanceInside];
          const limit = limitNormal(patch, end, 0.3)!;
          expect(distance(limit, surfaceNormal(patch, near, 0.3) ?? limit)).toBeLessThan(0.01);
          expect(
            distance(
              limit,
              limitNormal(bezierPatch(turn ? clean(base, rows).reverse() : clean(base, rows)), end, 0.3)!,
            ),
          ).toBeLessThan(1e-9);
        }
      }
    }
  });

  /** The net with its first rows in one point, exactly. */
  const clean = (base: ControlNet, rows: number): Point[][] =>
    base.map((row, i) => (i < rows ? row.map(() => [0, 1, 0]) : [...row]));

  test("nearly parallel tangents are parallel", () => {
    const sheared = (h: number) =>
      bezierPatch([
        [
          [0, 0, 0],
          [1, h, 0],
        ],
        [
          [1, 0, 0],
          [2, h, 0],
        ],
      ]);
    expect(surfaceNormal(sheared(1e-12), 0.5, 0.5)).toBeNull();
    expect(surfaceNormal(sheared(1e-8), 0.5, 0.5)).not.toBeNull();
  });

  test("a pinch inside the domain has no limit: it would differ on both sides", () => {
    const pinch: ControlNet = [
      [
        [-1, 1, 0],
        [-1, -1, 0],
      ],
      [
        [1, -1, 0],
        [1, 1, 0],
      ],
    ];
    const turned = pinch[0]!.map((_, j) => pinch.map((row) => row[j]!));
    expect(isCollapsed(bezierPatch(pinch), "u", 0.5)).toBe(true);
    expect(limitNormal(bezierPatch(pinch), 0.5, 0.3)).toBeNull();
    expect(limitNormal(bezierPatch(turned), 0.3, 0.5)).toBeNull();
  });

  /** A surface over [2, 3] × [5, 9] of which only derivatives at single places are given, without a bound. */
  const made = (partial: (u: number, v: number, k: number, l: number) => Point): Surface => ({
    dimension: 3,
    domain: [
      [2, 3],
      [5, 9],
    ],
    point: (u, v) => partial(u, v, 0, 0),
    partial,
  });

  test("an edge is looked at from end to end of its own interval", () => {
    for (const moving of [5, 7, 9]) {
      const surface = made((_, v, k, l) => [k === 1 && l === 0 ? 1 : 0, l === 1 && v === moving ? 1 : 0, 0]);
      expect(isCollapsed(surface, "u", 2)).toBe(false);
    }
    for (const moving of [2, 2.5, 3]) {
      const surface = made((u, _, k, l) => [k === 0 && l === 1 ? 1 : 0, k === 1 && u === moving ? 1 : 0, 0]);
      expect(isCollapsed(surface, "v", 5)).toBe(false);
    }
    expect(isCollapsed(bezierPatch([[[1, 2, 3]]]), "u", 0)).toBe(true);
  });

  test("without a bound for the speed, tangents are measured by each other", () => {
    const thin = made((_u, _v, k, l) => [k === 1 && l === 0 ? 1 : 0, k === 0 && l === 1 ? 1e-12 : 0, 0]);
    expect(surfaceNormal(thin, 2.5, 6)).toBeNull();
    expect(isCollapsed(thin, "u", 2)).toBe(true);
    expect(isCollapsed(thin, "v", 5)).toBe(false);
    const wide = made((_u, _v, k, l) => [k === 1 && l === 0 ? 1e-12 : 0, k === 0 && l === 1 ? 1 : 0, 0]);
    expect(surfaceNormal(wide, 2.5, 6)).toBeNull();
    expect(isCollapsed(wide, "v", 5)).toBe(true);
    expect(isCollapsed(wide, "u", 2)).toBe(false);
    const twisted = made((_u, _v, k, l) => [
      k === 1 && l === 0 ? 1e-12 : 0,
      k === 0 && l === 1 ? 1e-12 : 0,
      k * l,
    ]);
    expect(surfaceNormal(twisted, 2.5, 6)).toBeNull();
    // S_u and S_uv parallel but for rounding: the normal comes from the next order.
    const ridge = made((_u, _v, k, l) => {
      if (k === 1 && l === 0) return [1, 0, 0];
      if (k === 1 && l === 1) return [1, 0, 1e-14];
      return k === 2 && l === 1 ? [0, 1, 0] : [0, 0, 0];
    });
    expect(distance(limitNormal(ridge, 2, 6)!, [0, 0, 1])).toBeLessThan(1e-9);
  });

  test("where two collapsed edges meet, the one that has a limit decides", () => {
    // The edges u = 0 and v = 0 are one point; along v = 0 nothing moves, along u = 0 neither.
    const corner: ControlNet = bicubic.map((row, i) =>
      row.map((p, j) => (i === 0 || j === 0 ? [0, 0, 0] : p)),
    );
    expect(limitNormal(bezierPatch(corner), 0, 0)).toBeNull();
    expect(limitNormal(bezierPatch(corner), 0, 0.5)).not.toBeNull();
    expect(limitNormal(bezierPatch(corner), 0.5, 0)).not.toBeNull();
  });

  test("isCollapsed tells the edges that are points from those that are not", () => {
    const patch = bezierPatch(collapsed("u1"));
    expect([isCollapsed(patch, "u", 1), isCollapsed(patch, "u", 0)]).toEqual([true, false]);
    expect([isCollapsed(patch, "v", 1), isCollapsed(patch, "v", 0)]).toEqual([false, false]);
    expect(isCollapsed(sphereSurface(), "v", Math.PI / 2)).toBe(true);
    // Only the middle of this edge moves.
    const almost: ControlNet = [
      [
        [0, 0, 0],
        [0, 0, 1],
        [0, 0, 0],
      ],
      [
        [1, 0, 0],
        [1, 1, 0],
        [1, 2, 0],
      ],
    ];
    expect(isCollapsed(bezierPatch(almost), "u", 0)).toBe(false);
  });
});

describe("curvature", () => {
  test("of spheres: 1/r², and −1/r towards the outward normal", () => {
    forAll([fc.double({ min: 0.1, max: 50, noNaN: true }), unit, unit], (r, s, t) => {
      const [u, v] = [2 * Math.PI * s, Math.PI * (0.98 * t - 0.49)];
      const sphere = sphereSurface(r, [1, 2, 3]);
      const { gaussian, mean, principal } = surfaceCurvature(sphere, u, v)!;
      expect(gaussian * r * r).toBeCloseTo(1, 9);
      expect(mean * r).toBeCloseTo(-1, 9);
      expect(principal[0] * r).toBeCloseTo(-1, 6);
      expect(principal[1] * r).toBeCloseTo(-1, 6);
      const outward = normalize(sub(sphere.point(u, v), [1, 2, 3]))!;
      expect(distance(surfaceNormal(sphere, u, v)!, outward)).toBeLessThan(1e-10);
    });
  });

  test("of a cylinder of radius 2: 0 and 1/2 along its two directions", () => {
    const cylinder = revolvedSurface(
      bezierCurve([
        [2, 0],
        [2, 5],
      ]),
    );
    const { gaussian, mean, principal } = surfaceCurvature(cylinder, 1, 0.3)!;
    expect(gaussian).toBeCloseTo(0, 14);
    expect(mean).toBeCloseTo(-0.25, 14);
    expect(principal.map((k) => k + 0)).toEqual([expect.closeTo(0, 14), expect.closeTo(-0.5, 14)]);
  });

  test("of a graph: K = (f_xx f_yy − f_xy²)/(1 + f_x² + f_y²)²", () => {
    const partials: Record<string, (x: number, y: number) => number> = {
      "00": (x, y) => x * x * y + y * y,
      "10": (x, y) => 2 * x * y,
      "01": (x, y) => x * x + 2 * y,
      "20": (_, y) => 2 * y,
      "11": (x) => 2 * x,
      "02": () => 2,
    };
    const f = (x: number, y: number, k: number, l: number): number => partials[`${k}${l}`]?.(x, y) ?? 0;
    const surface = graphSurface(f, [-1, 1], [-2, 2]);
    forAll([unit, unit], (s, t) => {
      const [x, y] = [2 * s - 1, 4 * t - 2];
      const [fx, fy, fxx, fxy, fyy] = [f(x, y, 1, 0), f(x, y, 0, 1), 2 * y, 2 * x, 2];
      const w = 1 + fx * fx + fy * fy;
      const { gaussian, mean, principal } = surfaceCurvature(surface, x, y)!;
      expect(gaussian).toBeCloseTo((fxx * fyy - fxy * fxy) / w ** 2, 10);
      expect(mean).toBeCloseTo(
        ((1 + fy * fy) * fxx - 2 * fx * fy * fxy + (1 + fx * fx) * fyy) / (2 * w ** 1.5),
        10,
      );
      expect(principal[0] * principal[1]).toBeCloseTo(gaussian, 9);
      expect((principal[0] + principal[1]) / 2).toBeCloseTo(mean, 10);
      expect(principal[0]).toBeGreaterThanOrEqual(principal[1]);
    });
  });

  test("forms and curvatures belong together; none without a normal", () => {
    forAll([unit, unit], (u, v) => {
      const patch = bezierPatch(bicubic);
      const { E, F, G, L, M, N, normal } = fundamentalForms(patch, u, v)!;
      const { gaussian, mean } = surfaceCurvature(patch, u, v)!;
      expect((L * N - M * M) / (E * G - F * F)).toBeCloseTo(gaussian, 10);
      expect((E * N - 2 * F * M + G * L) / (2 * (E * G - F * F))).toBeCloseTo(mean, 10);
      expect(normal).toEqual(surfaceNormal(patch, u, v));
    });
    expect(fundamentalForms(bezierPatch([[[1, 2, 3]]]), 0, 0)).toBeNull();
    expect(surfaceCurvature(bezierPatch([[[1, 2, 3]]]), 0, 0)).toBeNull();
    expect(surfaceCurvature(sphereSurface(), 1, Math.PI / 2)).toBeNull();
  });

  test("scales with the surface, however small or large", () => {
    for (const r of [1e-150, 1e-60, 1e60, 1e150]) {
      const { mean, gaussian } = surfaceCurvature(sphereSurface(r), 1, 0.5)!;
      expect(mean * r).toBeCloseTo(-1, 10);
      expect(Math.sqrt(gaussian) * r).toBeCloseTo(1, 10);
    }
  });
});

describe("example surfaces", () => {
  const a = bezierCurve([
    [0, 0, 0],
    [1, 2, 0],
    [3, 0, 1],
  ]);
  const b = bezierCurve([
    [0, 3, 1],
    [2, 3, 0],
    [3, 4, 2],
  ]);
  const vase = revolvedSurface(
    bezierCurve([
      [1, 0],
      [3, 1],
      [0.5, 2],
      [1, 3],
    ]),
  );
  const wave = graphSurface(
    (x, y, k, l) => Math.sin(x + (k * Math.PI) / 2) * Math.cos(2 * y + (l * Math.PI) / 2) * 2 ** l,
    [0, 3],
    [0, 1],
  );
  const surfaces: [string, Surface][] = [
    ["sphere", sphereSurface(2, [1, 0, 0])],
    ["vase", vase],
    ["ruled", ruledSurface(a, b)],
    ["wave", wave],
  ];

  test.each(surfaces)("%s: partial derivatives are limits of differences", (_, surface) => {
    const [[u0, u1], [v0, v1]] = surface.domain;
    forAll([unit, unit], (s, t) => {
      const [u, v] = [u0 + s * (u1 - u0), v0 + t * (v1 - v0)];
      const misses = orders.map(([k, l]) =>
        distance(surface.partial(u, v, k, l), numeric(surface, u, v, k, l)),
      );
      expect(Math.max(...misses)).toBeLessThan(1e-4);
      expect(surface.partial(u, v, 0, 0)).toEqual(surface.point(u, v));
      if (surface.speed !== undefined) {
        expect(norm(surface.partial(u, v, 1, 0))).toBeLessThanOrEqual(surface.speed + 1e-12);
      }
    });
    expect(surface.dimension).toBe(3);
  });

  test("the sphere is ‖x − c‖ = r; at the poles the limit of the normal is the axis", () => {
    const sphere = sphereSurface(2, [1, 0, 0]);
    forAll([unit, unit], (s, t) => {
      expect(distance(sphere.point(7 * s, 2 * t - 1), [1, 0, 0])).toBeCloseTo(2, 13);
    });
    expect(surfaceNormal(sphere, 1, Math.PI / 2)).toBeNull();
    expect(distance(limitNormal(sphere, 1, Math.PI / 2)!, [0, 0, 1])).toBeLessThan(1e-12);
    expect(distance(limitNormal(sphere, 1, -Math.PI / 2)!, [0, 0, -1])).toBeLessThan(1e-12);
    expect(sphereSurface().point(0, 0)).toEqual([1, 0, 0]);
    expect(sphereSurface().domain[0]).toEqual([0, 2 * Math.PI]);
  });

  test("the profile turns about the z axis; on the axis the limit of the normal exists", () => {
    expect(vase.point(0, 0)).toEqual([1, 0, 0]);
    expect(distance(vase.point(Math.PI / 2, 1), [0, 1, 3])).toBeLessThan(1e-14);
    const cap = revolvedSurface(
      bezierCurve([
        [0, 0],
        [1, 0],
        [1, 1],
      ]),
    );
    expect(surfaceNormal(cap, 1, 0)).toBeNull();
    expect(distance(limitNormal(cap, 1, 0)!, [0, 0, -1])).toBeLessThan(1e-12);
  });

  test("a ruled surface holds straight lines and is nowhere convex", () => {
    const ruled = ruledSurface(a, b);
    forAll([unit, unit], (u, v) => {
      expect(distance(ruled.point(u, v), combine([1 - v, v], [a.point(u), b.point(u)]))).toBeLessThan(1e-13);
      expect(surfaceCurvature(ruled, u, v)?.gaussian ?? 0).toBeLessThanOrEqual(1e-12);
      expect(ruled.partial(u, v, 1, 2)).toEqual([0, 0, 0]);
    });
    expect(ruled.domain).toEqual([
      [0, 1],
      [0, 1],
    ]);
    const cone = ruledSurface(
      bezierCurve([
        [0, 0, 1],
        [0, 0, 1],
      ]),
      bezierCurve([
        [1, 0, 0],
        [0, 1, 0],
      ]),
    );
    expect(surfaceNormal(cone, 0.5, 0)).toBeNull();
    expect(limitNormal(cone, 0.5, 0)).not.toBeNull();
  });

  test("bad arguments are named", () => {
    expect(() => graphSurface(() => 0, [1, 0], [0, 1])).toThrow(/^xInterval/);
    expect(() => graphSurface(() => 0, [0, 1], [1, 1])).toThrow(/^yInterval/);
    expect(() => sphereSurface(0)).toThrow("radius: expected a positive finite number, got 0");
    expect(() => sphereSurface(1, [0, 0])).toThrow("centre: expected 3 coordinates, got [0, 0]");
    expect(() => revolvedSurface(a)).toThrow("profile: expected a curve of dimension 2, got 3");
    expect(() => ruledSurface(a, bezierCurve([[0, 0]]))).toThrow("b: expected a curve of dimension 3, got 2");
    expect(() => ruledSurface(a, bezierCurve([[0, 0, 0]], [0, 2]))).toThrow(
      "b.domain: expected [0,1] as of a, got [0,2]",
    );
    expect(() => ruledSurface(a, bezierCurve([[0, 0, 0]], [-1, 1]))).toThrow(/^b\.domain: /);
  });
});

describe("B-spline surfaces", () => {
  const data = {
    degreeU: 3,
    degreeV: 2,
    knotsU: [0, 0, 0, 0, 1, 2, 2, 2, 2],
    knotsV: [0, 0, 0, 0.5, 0.5, 1, 1, 1],
    controlPoints: Array.from({ length: 5 }, (_, i) =>
      Array.from({ length: 5 }, (_, j): Point => [i, j + 0.1 * i * i, Math.sin(2 * i + 3 * j)]),
    ),
  };
  const surface = bsplineSurface(data);

  test("S = Σ Σ d_ij·N_i·N_j, with all derivatives", () => {
    forAll([unit, unit, fc.integer({ min: 0, max: 4 }), fc.integer({ min: 0, max: 3 })], (s, v, k, l) => {
      const u = 2 * s;
      const [nu, nv] = [bsplineBasis(3, data.knotsU, u, k), bsplineBasis(2, data.knotsV, v, l)];
      const wanted = combine(
        nu,
        data.controlPoints.map((row) => combine(nv, row)),
      );
      expect(distance(surface.partial(u, v, k, l), wanted)).toBeLessThan(1e-10 * size([wanted]));
      expect(surface.point(u, v)).toEqual(surface.partial(u, v, 0, 0));
      expect(norm(surface.partial(u, v, 1, 0))).toBeLessThanOrEqual(surface.speed! + 1e-12);
      expect(norm(surface.partial(u, v, 0, 1))).toBeLessThanOrEqual(surface.speed! + 1e-12);
    });
    expect([surface.domain, surface.dimension]).toEqual([
      [
        [0, 2],
        [0, 1],
      ],
      3,
    ]);
    const stretched = (u: number, v: number) =>
      bsplineSurface({
        degreeU: 1,
        degreeV: 1,
        knotsU: [0, 0, 1, 1],
        knotsV: [0, 0, 1, 1],
        controlPoints: [
          [
            [0, 0, 0],
            [0, v, 0],
          ],
          [
            [u, 0, 0],
            [u, v, 0],
          ],
        ],
      }).speed;
    expect([stretched(3, 2), stretched(2, 5)]).toEqual([3, 5]);
  });

  test("its Bézier patches are the surface on each pair of spans", () => {
    const { breaksU, breaksV, patches } = bsplineSurfaceToPatches(data);
    expect(breaksU).toEqual(knotBreaks(3, data.knotsU));
    expect(breaksV).toEqual(knotBreaks(2, data.knotsV));
    expect([patches.length, patches[0]!.length]).toEqual([2, 2]);
    forAll([unit, unit], (s, t) => {
      const misses = patches.flatMap((row, a) =>
        row.map((patch, b) => {
          const u = breaksU[a]! + s * (breaksU[a + 1]! - breaksU[a]!);
          const v = breaksV[b]! + t * (breaksV[b + 1]! - breaksV[b]!);
          return distance(patchPoint(patch, s, t), surface.point(u, v));
        }),
      );
      expect(Math.max(...misses)).toBeLessThan(1e-12);
    });
  });

  test("bad data are named, with the direction", () => {
    expect(() => bsplineSurface({ ...data, knotsU: [0, 1] })).toThrow(
      /^knotsU: expected 9 = 5 control points/,
    );
    expect(() => bsplineSurface({ ...data, knotsV: [0, 0, 0, 0.5, 0.4, 1, 1, 1] })).toThrow(
      /^knotsV\[4\]: expected a number of at least knots\[3\]/,
    );
    expect(() => bsplineSurface({ ...data, degreeV: -1 })).toThrow(/^degreeV: /);
    expect(() => bsplineSurface({ ...data, controlPoints: [] })).toThrow(/^controlPoints: /);
    expect(() => bsplineSurfaceToPatches({ ...data, degreeU: 0.5 })).toThrow(/^degreeU: /);
    expect(clampedKnots(1, 2)).toEqual([0, 0, 1, 1]);
  });
});
