import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  bezierPatch,
  type ControlNet,
  distance,
  limitNormal,
  norm,
  type Point,
  parallelogramArea,
  patchNormalInto,
  patchPartial,
  patchPoint,
  patchPointInto,
  patchTessellator,
  surfaceNormal,
  toFlatNet,
} from "../../src/math/index.ts";
import { forAll, point, size, unit } from "./property.ts";

const net = fc.tuple(fc.integer({ min: 0, max: 5 }), fc.integer({ min: 0, max: 5 })).chain(([m, n]) =>
  fc.array(fc.array(point(3), { minLength: n + 1, maxLength: n + 1 }), {
    minLength: m + 1,
    maxLength: m + 1,
  }),
);
const degrees = (c: ControlNet) => [c.length - 1, c[0]!.length - 1] as const;
const at = (flat: ArrayLike<number>, k: number): Point => [flat[3 * k]!, flat[3 * k + 1]!, flat[3 * k + 2]!];

const tip: ControlNet = [
  [
    [0, 0, 1],
    [0, 0, 1],
    [0, 0, 1],
  ],
  [
    [1, -1, 1],
    [1, 0, 2],
    [1, 1, 1],
  ],
  [
    [2, -1, 0],
    [2, 0, 1],
    [2, 1, 0],
  ],
];

test("a net's coordinates follow each other row by row", () => {
  expect([
    ...toFlatNet([
      [
        [1, 2, 3],
        [4, 5, 6],
      ],
      [
        [7, 8, 9],
        [10, 11, 12],
      ],
    ]),
  ]).toEqual([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
});

describe("single points and normals", () => {
  test("are those of the readable form", () => {
    forAll([net, unit, unit], (c, u, v) => {
      const [m, n] = degrees(c);
      const out = [9, 9, 9, 9, 9, 9, 9, 9];
      patchPointInto(out, toFlatNet(c), m, n, u, v, 1);
      expect(distance(out.slice(1, 4), patchPoint(c, u, v))).toBeLessThan(1e-12 * size(c.flat()));
      const regular = patchNormalInto(out, toFlatNet(c), m, n, u, v, 4);
      const normal = surfaceNormal(bezierPatch(c), u, v);
      if (!regular) expect(out.slice(4, 7)).toEqual([0, 0, 0]);
      const [su, sv] = [patchPartial(c, u, v, 1, 0), patchPartial(c, u, v, 0, 1)];
      // Squares of tinier tangents underflow.
      const sizable = Math.min(norm(su), norm(sv)) > 1e-50;
      if (sizable && parallelogramArea(su, sv) > 1e-8 * norm(su) * norm(sv)) expect(regular).toBe(true);
      if (normal && regular) expect(distance(out.slice(4, 7), normal)).toBeLessThan(1e-4);
      expect([out[0], out[7]]).toEqual([9, 9]);
    });
  });

  test("write to the start by default and say where there is no normal", () => {
    const out = [0, 0, 0];
    patchPointInto(out, toFlatNet(tip), 2, 2, 1, 1);
    expect(out).toEqual([2, 1, 0]);
    expect(patchNormalInto(out, toFlatNet(tip), 2, 2, 0, 0.5)).toBe(false);
    expect(out).toEqual([0, 0, 0]);
    expect(patchNormalInto(out, toFlatNet(tip), 2, 2, 0.5, 0.5)).toBe(true);
    expect(distance(out, surfaceNormal(bezierPatch(tip), 0.5, 0.5)!)).toBeLessThan(1e-14);
    // Parallel tangents.
    expect(
      patchNormalInto(
        out,
        toFlatNet([
          [
            [0, 0, 0],
            [1, 0, 0],
          ],
          [
            [2, 0, 0],
            [2, 2, 1],
          ],
        ]),
        1,
        1,
        0,
        0,
      ),
    ).toBe(false);
  });
});

test("tangents are parallel if the sine of their angle is below 1e-10, whatever their lengths", () => {
  for (const [a, b] of [
    [1, 1],
    [1e4, 1e4],
    [1e-4, 1e-4],
    [1e5, 1e-2],
  ] as const) {
    // S_u = (a, 0, 0), S_v = b·(cos, sin, 0).
    const net = (sine: number) =>
      toFlatNet([
        [
          [0, 0, 0],
          [b, b * sine, 0],
        ],
        [
          [a, 0, 0],
          [a + b, b * sine, 0],
        ],
      ]);
    const out = [0, 0, 0];
    expect(patchNormalInto(out, net(1e-11), 1, 1, 0, 0)).toBe(false);
    expect(patchNormalInto(out, net(1e-8), 1, 1, 0, 0)).toBe(true);
    expect(out).toEqual([0, 0, 1]);
  }
});

describe("patchTessellator", () => {
  test("reads a regular net twice for each row of samples: every normal is found in passing", () => {
    const c: ControlNet = [
      [
        [0, 0, 0],
        [0.2, 1, 5],
        [0, 2, -3],
      ],
      [
        [1, 0.1, 4],
        [1, 1, 0],
        [1.2, 2, 5],
      ],
      [
        [2, 0, -2],
        [2, 1.1, 6],
        [2, 2, 1],
      ],
      [
        [3, 0.3, 5],
        [3, 1, -4],
        [3.1, 2, 0],
      ],
    ];
    let reads = 0;
    const counted = new Proxy([...toFlatNet(c)], {
      get: (list, key) => {
        if (key !== "length") reads++;
        return Reflect.get(list, key);
      },
    });
    const [positions, normals] = [new Float64Array(3 * 5 * 4), new Float64Array(3 * 5 * 4)];
    const tessellate = patchTessellator(3, 2, 4, 3);
    tessellate(counted, positions, normals);
    expect(reads).toBe(36 * (2 * 5 + 1));
    reads = 0;
    tessellate(counted, positions);
    expect(reads).toBe(36 * 5);
  });

  test("samples points and normals of the readable form, row by row in u", () => {
    forAll([net, fc.integer({ min: 1, max: 4 }), fc.integer({ min: 1, max: 4 })], (c, stepsU, stepsV) => {
      const [m, n] = degrees(c);
      const count = (stepsU + 1) * (stepsV + 1);
      const positions = new Float64Array(3 * count);
      const normals = new Float64Array(3 * count).fill(7);
      patchTessellator(m, n, stepsU, stepsV)(toFlatNet(c), positions, normals);
      const patch = bezierPatch(c);
      const tolerance = 1e-12 * size(c.flat());
      let miss = 0;
      let tilt = 0;
      for (let a = 0, k = 0; a <= stepsU; a++) {
        for (let b = 0; b <= stepsV; b++, k++) {
          const [u, v] = [a / stepsU, b / stepsV];
          miss = Math.max(miss, distance(at(positions, k), patch.point(u, v)));
          const wanted = limitNormal(patch, u, v) ?? [0, 0, 0];
          const length = Math.hypot(...at(normals, k));
          if (length !== 0) tilt = Math.max(tilt, distance(at(normals, k), wanted));
          else expect(surfaceNormal(patch, u, v)).toBeNull();
        }
      }
      expect(miss).toBeLessThan(tolerance);
      expect(tilt).toBeLessThan(1e-3);
    });
  });

  test("writes the limit of the normal on a collapsed edge, zeros where there is none", () => {
    const tessellate = patchTessellator(2, 2, 2, 2);
    const [positions, normals] = [new Float32Array(27), new Float32Array(27)];
    tessellate(toFlatNet(tip), positions, normals);
    const patch = bezierPatch(tip);
    for (let b = 0; b <= 2; b++) {
      expect(distance(at(normals, b), limitNormal(patch, 0, b / 2)!)).toBeLessThan(1e-6);
      expect(at(positions, b)).toEqual([0, 0, 1]);
    }
    // The same function again, with a net that is one point: nothing is left from before.
    tessellate(new Float64Array(27).fill(2), positions, normals);
    expect([...normals]).toEqual(new Array(27).fill(0));
    expect([...positions]).toEqual(new Array(27).fill(2));
  });

  test("finds the collapsed edge though its points differ by rounding", () => {
    const noisy = tip.map((row, i) => row.map((p, j) => (i === 0 ? [1e-15 * j, 0, 1] : p)));
    const normals = new Float64Array(27);
    patchTessellator(2, 2, 2, 2)(toFlatNet(noisy), new Float64Array(27), normals);
    expect(distance(at(normals, 1), limitNormal(bezierPatch(tip), 0, 0.5)!)).toBeLessThan(1e-10);
    const turned = noisy[0]!.map((_, j) => noisy.map((row) => row[j]!));
    patchTessellator(2, 2, 2, 2)(toFlatNet(turned), new Float64Array(27), normals);
    expect(
      distance(
        at(normals, 3),
        limitNormal(bezierPatch(tip), 0, 0.5)!.map((x) => -x),
      ),
    ).toBeLessThan(1e-10);
    expect(distance(at(normals, 4), surfaceNormal(bezierPatch(turned), 0.5, 0.5)!)).toBeLessThan(1e-13);
  });

  test("without a place for normals it writes positions only", () => {
    const positions = new Float64Array(12);
    patchTessellator(1, 1, 1, 1)([0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 5], positions);
    expect([...positions]).toEqual([0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 5]);
  });

  test("bad arguments are named", () => {
    expect(() => patchTessellator(-1, 1, 1, 1)).toThrow("m: expected a whole number from 0 to 64, got -1");
    expect(() => patchTessellator(1, 65, 1, 1)).toThrow(/^n: /);
    expect(() => patchTessellator(1, 1, 0, 1)).toThrow(
      "stepsU: expected a whole number of at least 1, got 0",
    );
    expect(() => patchTessellator(1, 1, 1, 0.5)).toThrow(/^stepsV: /);
    const tessellate = patchTessellator(1, 1, 1, 1);
    const twelve = new Float64Array(12);
    expect(() => tessellate(new Float64Array(11), twelve)).toThrow("net: expected 12 coordinates, got 11");
    expect(() => tessellate(new Float64Array(13), twelve)).toThrow("net: expected 12 coordinates, got 13");
    expect(() => tessellate(twelve, new Float64Array(11))).toThrow(
      "positions: expected at least 12 coordinates, got 11",
    );
    expect(() => tessellate(twelve, twelve, new Float64Array(11))).toThrow(
      "normals: expected at least 12 coordinates, got 11",
    );
    expect(() => tessellate(twelve, new Float64Array(13), new Float64Array(14))).not.toThrow();
  });
});
