import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { displayList } from "../../src/render/display-list.ts";
import type { Primitive, TextPrimitive } from "../../src/render/primitives.ts";
import { textWidth } from "../../src/render/text-width.ts";
import { disc, label, path, point, polyline, region } from "../../src/scene/draw.ts";
import { symbol, wording } from "../../src/scene/label.ts";
import type { Mark, XY } from "../../src/scene/marks.ts";
import type { View } from "../../src/scene/view.ts";
import { EACH, scene, views } from "./all-kinds.ts";

const plane: View = { label: { de: "a", en: "b" }, x: [0, 4], y: [0, 3], height: 0.75 };

function draw(marks: readonly Mark[], view: Partial<View> = {}, lit: string[] = []): readonly Primitive[] {
  const options = { width: 412, height: 312, lang: "de", lit: new Set(lit) } as const;
  return displayList({ plane: { ...plane, ...view } }, { plane: marks }, options).primitives;
}

const texts = (list: readonly Primitive[]) =>
  list
    .filter((one): one is TextPrimitive => one.kind === "text")
    .flatMap(({ role, runs }) => {
      const words = runs.map((run) => run.text);
      // The numbers of an axis are one text, but each stands for itself.
      return role === "axis" ? words : [words.join("")];
    });

describe("kinds of marks", () => {
  test.each(Object.keys(EACH) as (keyof typeof EACH)[])("%s is drawn", (kind) => {
    const window = kind === "patch" || kind === "ground" ? "space" : "plane";
    const bare = { ...views.plane!, grid: false };
    const { axes: _, ...plain } = bare;
    const { primitives } = displayList(
      { plane: plain, space: views.space! },
      { [window]: [EACH[kind]] },
      { width: 700, height: 700, lang: "de" },
    );
    expect(primitives.length).toBeGreaterThan(0);
  });

  test("a mark of no known kind is refused by name", () => {
    const odd = { kind: "cloud", key: "odd", role: "note" } as unknown as Mark;
    expect(() => draw([odd])).toThrow(RangeError);
    expect(() => draw([odd])).toThrow(/cloud/);
  });

  test("what belongs into space is refused in the plane", () => {
    expect(() => draw([EACH.ground])).toThrow(/ground needs a view into space/);
  });
});

describe("paths", () => {
  test("Bézier arcs stay Bézier arcs, mapped exactly", () => {
    const [only] = draw([
      path("p", "curve", [
        ["M", [0, 0]],
        ["C", [0, 3], [4, 3], [4, 0]],
        ["Q", [2, 1], [1, 0]],
      ]),
    ]);
    // 100 pixels a unit, six pixels of margin.
    expect(only).toMatchObject({
      kind: "path",
      steps: [
        ["M", [6, 306]],
        ["C", [6, 6], [406, 6], [406, 306]],
        ["Q", [206, 206], [106, 306]],
      ],
    });
  });

  test("are cut by their window only where they leave it", () => {
    const inner = polyline("a", "curve", [
      [0, 0],
      [4, 3],
    ]);
    const outer = polyline("b", "curve", [
      [0, 0],
      [5, 3],
    ]);
    const [a, b] = draw([inner, outer]);
    expect(a!.clip).toBeUndefined();
    expect(b!.clip).toEqual({ left: 4, top: 4, width: 404, height: 304 });
  });

  test("what is not finite interrupts a path and is never drawn", () => {
    const [only] = draw([
      polyline("a", "curve", [
        [0, 0],
        [1, 1],
        [2, Number.NaN],
        [3, 1],
        [4, Number.POSITIVE_INFINITY],
        [4, 2],
        [4, 3],
      ]),
    ]);
    expect(only).toMatchObject({
      steps: [
        ["M", [6, 306]],
        ["L", [106, 206]],
        ["M", [306, 206]],
        ["M", [406, 106]],
        ["L", [406, 6]],
      ],
    });
  });
});

describe("points and discs", () => {
  test("a handle is a ring with the shape of its index inside", () => {
    const square = draw([point("h", "handle", [2, 1], { index: 1 })]);
    expect(square.map(({ kind, part }) => [kind, part])).toEqual([
      ["circle", "ring"],
      ["path", "solid"],
    ]);
    expect(square[0]).toMatchObject({ at: [206, 206], radius: 9 });
    const round = draw([point("h", "handle", [2, 1])]);
    expect(round[1]).toMatchObject({ kind: "circle", part: "solid", radius: 5 });
  });

  test("points outside the window, or nowhere, are left out with their letters", () => {
    const nowhere: XY[] = [
      [9, 1],
      [Number.NaN, 1],
      [1, Number.NEGATIVE_INFINITY],
    ];
    for (const at of nowhere) {
      expect(
        draw([point("h", "handle", at), label("l", "handle", at, symbol("c")), disc("d", at, 1)]),
      ).toEqual([]);
    }
  });

  test("the area of a disc shows the weight; negative ones are hollow, with a minus; zero is nothing", () => {
    const radius = (weight: number) => {
      const [first] = draw([disc("d", [2, 1.5], weight)]);
      return first?.kind === "circle" ? first.radius : 0;
    };
    expect(radius(1) ** 2 / radius(0.25) ** 2).toBeCloseTo(4);
    expect(radius(-0.5)).toBeCloseTo(radius(0.5));
    expect(draw([disc("d", [2, 1.5], 0.5)]).map(({ part }) => part)).toEqual(["disc"]);
    expect(draw([disc("d", [2, 1.5], -0.5)]).map(({ part }) => part)).toEqual([
      "outline",
      "hollow",
      "outline",
    ]);
    expect(draw([disc("d", [2, 1.5], 0), disc("n", [2, 1.5], Number.NaN)])).toEqual([]);
  });

  test("a small weight's minus is not hidden under its handle", () => {
    const [, badge] = draw([disc("d", [2, 1.5], -0.001)]);
    expect(badge).toMatchObject({ kind: "circle", part: "hollow" });
    const [x, y] = (badge as Extract<Primitive, { kind: "circle" }>).at;
    expect(Math.hypot(x! - 206, y! - 156)).toBeGreaterThan(9 + 6);
  });
});

test("what is pointed at is lit, below itself; nothing else changes", () => {
  const marks = [EACH.path, EACH.point, EACH.arrow];
  const plain = draw(marks);
  const lit = draw(marks, {}, ["path", "point", "arrow", "unknown"]);
  const glow = (one: Primitive) => one.part === "glow" || one.part === "shine";
  expect(lit.filter((one) => !glow(one))).toEqual(plain);
  expect(lit.filter(glow)).toHaveLength(3);
  expect(glow(lit[0]!)).toBe(true);
});

test("lettering that stands alone is lit itself, that of a point is not lit twice", () => {
  const letter = label("l", "note", [2, 1], symbol("x"), { name: "x" });
  expect(draw([letter], {}, ["x"]).map(({ part }) => part)).toEqual(["shine", "plain"]);
  const parts = draw([point("p", "curve", [2, 1], { name: "x" }), letter], {}, ["x"]).map(({ part }) => part);
  expect(parts).toEqual(["shine", "point", "plain"]);
});

describe("rasters", () => {
  test("the first row of values lies at the bottom, levels run over the range", () => {
    const [raster] = draw([EACH.raster]);
    expect(raster).toMatchObject({ kind: "raster", columns: 3, rows: 2 });
    expect([...(raster as Extract<Primitive, { kind: "raster" }>).levels]).toEqual([
      191, 254, 255, 0, 64, 127,
    ]);
  });
});

describe("lettering", () => {
  const number = (at: XY) =>
    label("n", "weight", at, wording({ de: "0,216", en: "0.216" }), { place: "centre" });
  const box = (right: number) =>
    region("r", "weight", [
      [1, 1],
      [right, 1],
      [right, 2],
      [1, 2],
    ]);

  test("a number on a weight's region is left out where it does not fit", () => {
    expect(texts(draw([box(2), number([1.5, 1.5])]))).toEqual(["0,216"]);
    expect(texts(draw([box(1.2), number([1.1, 1.5])]))).toEqual([]);
    expect(texts(draw([number([1.1, 1.5])]))).toEqual(["0,216"]);
  });

  test("a rim of paper only where a line runs through", () => {
    const words = label("w", "note", [2, 1.5], wording({ de: "Wort", en: "word" }), { place: "centre" });
    const line = polyline("l", "curve", [
      [0, 1.5],
      [4, 1.5],
    ]);
    expect(draw([words]).at(-1)!.part).toBe("plain");
    expect(draw([line, words]).at(-1)!.part).toBe("text");
  });

  test("stays clear of the disc around its point", () => {
    const at = [2, 1.5];
    const [, letter] = draw([disc("d", at, 1), label("l", "handle", at, symbol("c"), { toward: [1, 0] })]);
    const [round] = draw([disc("d", at, 1)]);
    const reach = (letter as TextPrimitive).at[0]! - 206;
    expect(reach).toBeGreaterThan((round as Extract<Primitive, { kind: "circle" }>).radius);
  });

  test("toward means the plane's up, not the screen's", () => {
    const at = [2, 1.5];
    const [up] = draw([label("l", "note", at, symbol("c"), { toward: [0, 1] })]);
    const [down] = draw([label("l", "note", at, symbol("c"), { toward: [0, -1] })]);
    expect((up as TextPrimitive).at[1]).toBeLessThan((down as TextPrimitive).at[1]!);
  });
});

describe("grid and axes", () => {
  const axes: Partial<View> = { x: [-1, 1], y: [0, 0.5], fit: "stretch", grid: true };

  test("numbers are the reader's, at both axes, with names where there are some", () => {
    const list = draw([], { ...axes, axes: { x: symbol("t"), y: symbol("S") } });
    expect(texts(list)).toEqual(
      expect.arrayContaining(["−1", "−0,5", "0", "0,5", "1", "t", "S", "0,1", "0,2", "0,3", "0,4"]),
    );
    const english = displayList(
      { plane: { ...plane, ...axes, axes: {} } },
      {},
      { width: 412, height: 312, lang: "en" },
    ).primitives;
    expect(texts(english)).toContain("−0.5");
  });

  test("an axis without a name is drawn if the other one has none either, or if its name is empty", () => {
    const count = (names: View["axes"]) => texts(draw([], { ...axes, axes: names! })).length;
    const both = count({});
    expect(count({ x: symbol("") })).toBeLessThan(both);
    expect(count({ y: symbol("") })).toBeLessThan(both);
    expect(count({ x: symbol(""), y: symbol("") })).toBe(both);
  });

  test("no number leaves the drawing", () => {
    const list = draw([], { ...axes, axes: { x: symbol("t"), y: symbol("B", "i", "3") } });
    for (const one of list) {
      if (one.kind !== "text") continue;
      for (const { text, font, size, dx, dy } of one.runs) {
        const width = textWidth(text, font, size);
        const left =
          one.at[0]! + dx - (one.anchor === "end" ? width : one.anchor === "middle" ? width / 2 : 0);
        expect(left, text).toBeGreaterThanOrEqual(0);
        expect(left + width, text).toBeLessThanOrEqual(412);
        expect(one.at[1]! + dy - 0.7 * size, text).toBeGreaterThanOrEqual(0);
        expect(one.at[1]! + dy, text).toBeLessThan(312);
      }
    }
  });

  test("grid lines are one path, on the middle of pixels", () => {
    const [grid] = draw([], { grid: true });
    expect(grid).toMatchObject({ kind: "path", role: "grid" });
    for (const step of (grid as Extract<Primitive, { kind: "path" }>).steps) {
      const [x, y] = step[1] as XY;
      expect([x! % 1, y! % 1]).toContain(0.5);
    }
  });
});

test("pure: the same scene gives the same list, and a view without marks is just its frame", () => {
  const options = { width: 700, height: 500, lang: "en" } as const;
  const [a, b] = [displayList(views, scene, options), displayList(views, scene, options)];
  expect(JSON.stringify(a)).toBe(JSON.stringify(b));
  expect(draw([])).toEqual([]);
});

test("nothing but finite numbers, whatever numbers the marks have", () => {
  const coordinate = fc.oneof(
    fc.double(),
    fc.constantFrom(0, -0, Number.NaN, Number.POSITIVE_INFINITY, 1e300, -1e300, 1e-300),
    fc.double({ min: 0, max: 4, noNaN: true }),
  );
  const xy = fc.tuple(coordinate, coordinate);
  fc.assert(
    fc.property(xy, xy, xy, xy, coordinate, (a, b, c, d, w) => {
      const marks: Mark[] = [
        path("p", "curve", [["M", a], ["C", b, c, d], ["Q", a, c], ["Z"]]),
        region("r", "weight", [a, b, c]),
        point("h", "handle", a, { index: 3 }),
        disc("d", b, w),
        { kind: "arrow", key: "a", role: "tangent", from: a, to: b },
        label("l", "handle", c, symbol("c", 1), { toward: d }),
        label("n", "weight", c, symbol("c", 1), { place: "centre" }),
        { ...EACH.raster, x: [a[0], b[0]], y: [a[1], b[1]], values: [w, w, w, w, w, w], range: [a[0], w] },
      ];
      const numbers: unknown[] = [];
      JSON.stringify(draw(marks), (_, value: unknown) => {
        if (typeof value === "number") numbers.push(value);
        return value;
      });
      expect(numbers.every((value) => Number.isFinite(value))).toBe(true);
    }),
    { numRuns: 300 },
  );
});
