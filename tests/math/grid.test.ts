import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  axisCell,
  bilinearCell,
  type Grid,
  type Grid3,
  type GridMethod,
  gridMethods,
  gridSampler,
  nearestNode,
  sampleInto,
  trilinearSampler,
} from "../../src/math/index.ts";
import { coordinate, forAll, unit } from "./property.ts";

const exercise: Grid = {
  origin: [0, 0],
  spacing: [1, 1],
  values: [
    [0, 1, 3, 5],
    [2, 3, 2, 6],
    [4, 1, 4, 7],
    [6, 5, 8, 9],
  ],
};

/** The grid of a function, with columns × rows nodes. */
function gridOf(columns: number, rows: number, f: (x: number, y: number) => number): Grid {
  const [origin, spacing] = [[-1, 2] as const, [0.5, 0.25] as const];
  const values = Array.from({ length: rows }, (_, j) =>
    Array.from({ length: columns }, (_, i) => f(-1 + 0.5 * i, 2 + 0.25 * j)),
  );
  return { origin, spacing, values };
}

const small = fc
  .tuple(fc.integer({ min: 1, max: 6 }), fc.integer({ min: 1, max: 6 }))
  .chain(([columns, rows]) =>
    fc.array(fc.array(coordinate, { minLength: columns, maxLength: columns }), {
      minLength: rows,
      maxLength: rows,
    }),
  )
  .map((values): Grid => ({ origin: [-1, 2], spacing: [0.5, 0.25], values }));

describe("axisCell", () => {
  test("the last node belongs to the last cell; outside is moved to the border", () => {
    expect(axisCell(1, 0.5, 4, 1)).toEqual({ i: 0, alpha: 0 });
    expect(axisCell(1, 0.5, 4, 1.75)).toEqual({ i: 1, alpha: 0.5 });
    expect(axisCell(1, 0.5, 4, 2)).toEqual({ i: 2, alpha: 0 });
    expect(axisCell(1, 0.5, 4, 2.5)).toEqual({ i: 2, alpha: 1 });
    expect(axisCell(1, 0.5, 4, 99)).toEqual({ i: 2, alpha: 1 });
    expect(axisCell(1, 0.5, 4, -99)).toEqual({ i: 0, alpha: 0 });
    expect(axisCell(1, 0.5, 1, 7)).toEqual({ i: 0, alpha: 0 });
  });
});

describe("every method", () => {
  test("meets the nodes of the grid", () => {
    forAll([small], (grid) => {
      for (const method of gridMethods) {
        const sample = gridSampler(grid, method);
        grid.values.forEach((row, j) => {
          row.forEach((value, i) => {
            expect(sample(-1 + 0.5 * i, 2 + 0.25 * j)).toBeCloseTo(value, 10);
          });
        });
      }
    });
  });

  test("continues the border outside", () => {
    forAll([small, unit, unit], (grid, s, t) => {
      const [right, top] = [-1 + 0.5 * (grid.values[0]!.length - 1), 2 + 0.25 * (grid.values.length - 1)];
      const [x, y] = [-1 + s * (right + 1), 2 + t * (top - 2)];
      for (const method of gridMethods) {
        const sample = gridSampler(grid, method);
        expect(sample(right + 5, y)).toBe(sample(right, y));
        expect(sample(-9, y)).toBe(sample(-1, y));
        expect(sample(x, top + 5)).toBe(sample(x, top));
        expect(sample(x, -9)).toBe(sample(x, 2));
      }
    });
  });

  const inside = fc.tuple(unit, unit);
  const reproduces: [GridMethod, string, (x: number, y: number) => number][] = [
    ["bilinear", "1 + 2x − 3y + 4xy", (x, y) => 1 + 2 * x - 3 * y + 4 * x * y],
    ["catmullRom", "1 + 2x − 3y + 4xy", (x, y) => 1 + 2 * x - 3 * y + 4 * x * y],
    ["catmullRom", "(1 + x − x²)(2 − y + 3y²)", (x, y) => (1 + x - x * x) * (2 - y + 3 * y * y)],
    ["natural", "1 + 2x − 3y + 4xy", (x, y) => 1 + 2 * x - 3 * y + 4 * x * y],
  ];
  test.each(reproduces)("%s reproduces %s up to the border", (method, _, f) => {
    for (const [columns, rows] of [
      [6, 5],
      [3, 4],
      [4, 3],
    ] as const) {
      const sample = gridSampler(gridOf(columns, rows, f), method);
      forAll([inside], ([s, t]) => {
        const [x, y] = [-1 + s * 0.5 * (columns - 1), 2 + t * 0.25 * (rows - 1)];
        expect(sample(x, y)).toBeCloseTo(f(x, y), 10);
      });
    }
  });

  test("Catmull-Rom with two nodes is linear, with one constant", () => {
    const sample = gridSampler({ ...exercise, values: [[2, 6]] }, "catmullRom");
    expect(sample(0.25, 0)).toBeCloseTo(3, 14);
    const upright = gridSampler({ ...exercise, values: [[2], [6]] }, "natural");
    expect(upright(0, 0.25)).toBeCloseTo(3, 14);
    expect(gridSampler({ ...exercise, values: [[2]] }, "natural")(3, 4)).toBe(2);
  });

  test("Catmull-Rom is local: a node three cells away does not act; the natural spline is not", () => {
    const bump = gridOf(9, 9, (x, y) => (x === 1 && y === 3 ? 1 : 0));
    expect(gridSampler(bump, "catmullRom")(-0.25, 3)).toBe(0);
    expect(gridSampler(bump, "catmullRom")(0.25, 3)).toBeCloseTo(-1 / 16, 14);
    expect(gridSampler(bump, "natural")(-0.25, 3)).toBeGreaterThan(0.001);
    expect(gridSampler(bump, "natural")(1, 2.625)).not.toBeCloseTo(0, 3);
  });

  test("the natural spline is C²: second differences agree on both sides of a node", () => {
    const sample = gridSampler(
      gridOf(7, 7, (x, y) => Math.sin(3 * x) * Math.cos(8 * y)),
      "natural",
    );
    const e = 1e-3;
    const second = (x: number) => (sample(x - e, 2.6) - 2 * sample(x, 2.6) + sample(x + e, 2.6)) / e ** 2;
    expect(second(0.5 - 2 * e)).toBeCloseTo(second(0.5 + 2 * e), 0);
    const upright = (y: number) => (sample(0.3, y - e) - 2 * sample(0.3, y) + sample(0.3, y + e)) / e ** 2;
    expect(Math.abs(upright(2.5 - 2 * e) - upright(2.5 + 2 * e))).toBeLessThan(2);
  });
});

describe("nearest node", () => {
  test("half way the lower node wins, on both axes", () => {
    expect(nearestNode(exercise, 1.75, 1.75)).toEqual([2, 2]);
    expect(nearestNode(exercise, 1.5, 2.5)).toEqual([1, 2]);
    expect(nearestNode(exercise, 2.5, 0.5)).toEqual([2, 0]);
    expect(nearestNode(exercise, 3, 3)).toEqual([3, 3]);
    expect(nearestNode(exercise, -4, 40)).toEqual([0, 3]);
  });
});

describe("bilinear cell", () => {
  test("the lecture's numbers, with both auxiliary values and the four areas", () => {
    const cell = bilinearCell(2, 6, 0, 4, 0.75, 0.5);
    expect(cell).toEqual({ h0: 5, h1: 3, value: 4, weights: [0.125, 0.375, 0.125, 0.375] });
  });

  test("the exercise's weights 1/16, 3/16, 3/16, 9/16", () => {
    expect(bilinearCell(1, 2, 3, 4, 0.75, 0.75).weights).toEqual([1 / 16, 3 / 16, 3 / 16, 9 / 16]);
  });

  test("the weights add up to 1 and give the value", () => {
    const corner = fc.tuple(coordinate, coordinate, coordinate, coordinate);
    forAll([corner, unit, unit], (v, alpha, beta) => {
      const { value, weights } = bilinearCell(...v, alpha, beta);
      expect(weights.reduce((sum, w) => sum + w)).toBeCloseTo(1, 13);
      expect(weights.reduce((sum, w, i) => sum + w * v[i]!, 0)).toBeCloseTo(value, 10);
    });
  });

  test("a bad number is named", () => {
    const bad = Number.NaN;
    expect(() => bilinearCell(bad, 0, 0, 0, 0, 0)).toThrow("v00: expected a finite number, got NaN");
    expect(() => bilinearCell(0, bad, 0, 0, 0, 0)).toThrow(/^v10: /);
    expect(() => bilinearCell(0, 0, bad, 0, 0, 0)).toThrow(/^v01: /);
    expect(() => bilinearCell(0, 0, 0, bad, 0, 0)).toThrow(/^v11: /);
    expect(() => bilinearCell(0, 0, 0, 0, bad, 0)).toThrow(/^alpha: /);
    expect(() => bilinearCell(0, 0, 0, 0, 0, bad)).toThrow(/^beta: /);
  });
});

describe("trilinear", () => {
  const cube: Grid3 = {
    origin: [1, 2, 3],
    spacing: [1, 2, 4],
    values: [
      [
        [0, 1],
        [2, 3],
      ],
      [
        [4, 5],
        [6, 7],
      ],
    ],
  };

  test("reproduces a function linear in each coordinate", () => {
    const sample = trilinearSampler(cube);
    forAll([unit, unit, unit], (a, b, c) => {
      expect(sample(1 + a, 2 + 2 * b, 3 + 4 * c)).toBeCloseTo(a + 2 * b + 4 * c, 12);
    });
    expect(sample(0, 0, 0)).toBe(0);
    expect(sample(9, 9, 19)).toBe(7);
    expect(trilinearSampler({ ...cube, values: [[[5]]] })(1, 2, 3)).toBe(5);
  });

  test("bad grids are named", () => {
    expect(() => trilinearSampler({ ...cube, values: [] })).toThrow(
      "grid.values: expected at least 1 layer, got none",
    );
    expect(() => trilinearSampler({ ...cube, values: [[[1], [2]], [[3]]] })).toThrow(
      "grid.values[1]: expected 2 rows as in layer 0, got 1",
    );
    expect(() => trilinearSampler({ ...cube, values: [[[1]], [[3, 4]]] })).toThrow(
      "grid.values[1][0]: expected 1 values as in the first row, got 2",
    );
    expect(() => trilinearSampler({ ...cube, spacing: [1, 2, 0] })).toThrow(
      "grid.spacing[2]: expected a positive finite number, got 0",
    );
    expect(() => trilinearSampler({ ...cube, origin: [0, 0, Number.NaN] })).toThrow(/^grid\.origin\[2\]: /);
    expect(() => trilinearSampler({ ...cube, values: [[[Number.NaN]]] })).toThrow(
      /^grid\.values\[0\]\[0\]\[0\]: /,
    );
  });
});

describe("gridSampler", () => {
  test("bad grids and methods are named", () => {
    expect(() => gridSampler({ ...exercise, values: [] }, "nearest")).toThrow(
      "grid.values: expected at least 1 row, got none",
    );
    expect(() => gridSampler({ ...exercise, values: [[]] }, "nearest")).toThrow(
      "grid.values[0]: expected at least 1 number, got none",
    );
    expect(() => gridSampler({ ...exercise, values: [[1, 2], [3]] }, "nearest")).toThrow(
      "grid.values[1]: expected 2 values as in the first row, got 1",
    );
    expect(() => gridSampler({ ...exercise, spacing: [-1, 1] }, "nearest")).toThrow(/^grid\.spacing\[0\]: /);
    expect(() => gridSampler({ ...exercise, origin: [0, Number.NaN] }, "nearest")).toThrow(
      /^grid\.origin\[1\]: /,
    );
    expect(() => gridSampler(exercise, "cubic" as GridMethod)).toThrow(
      'method: expected one of nearest, bilinear, catmullRom, natural, got "cubic"',
    );
  });

  test("the batch form samples both ends of both intervals, row by row", () => {
    const out = new Float64Array(6).fill(-1);
    sampleInto(out, (x, y) => 10 * y + x, 3, 2, [1, 2], [5, 7]);
    expect([...out]).toEqual([51, 51.5, 52, 71, 71.5, 72]);
    expect(() => sampleInto(out, () => 0, 1, 2, [0, 1], [0, 1])).toThrow(
      "columns, rows: expected at least 2 each, got 1 and 2",
    );
    expect(() => sampleInto(out, () => 0, 2, 1, [0, 1], [0, 1])).toThrow(/^columns, rows: /);
    expect(() => sampleInto(out, () => 0, 3, 3, [0, 1], [0, 1])).toThrow(
      "out: expected room for 9 samples, got 6",
    );
  });
});
