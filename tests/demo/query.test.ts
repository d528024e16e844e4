import fc from "fast-check";
import { expect, test } from "vitest";
import { readQuery, splitQuery, writeQuery } from "../../src/demo/query.ts";
import { changed, initialState } from "../../src/demo/state.ts";
import { sample } from "./sample.ts";

const initial = initialState(sample);
const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
const point = fc.tuple(coordinate, coordinate);
const state = fc.record({
  t: fc.double({ min: 0, max: 1, noNaN: true }),
  n: fc.integer({ min: 1, max: 9 }),
  hull: fc.boolean(),
  mode: fc.constantFrom("a", "b-c"),
  points: fc.array(point, { minLength: 2, maxLength: 5 }),
  m: point,
  nodes: fc.array(coordinate, { minLength: 1, maxLength: 4 }),
  values: fc.tuple(point, point),
  patch: fc.tuple(
    fc.tuple(fc.tuple(coordinate, coordinate, coordinate), fc.tuple(coordinate, coordinate, coordinate)),
    fc.tuple(fc.tuple(coordinate, coordinate, coordinate), fc.tuple(coordinate, coordinate, coordinate)),
  ),
  drawing: fc.array(point, { maxLength: 6 }),
});

test("decoding what was encoded gives the same state, to the last bit", () => {
  fc.assert(
    fc.property(state, (values) => {
      const before = changed(sample, initial, values);
      const { patch, problems } = readQuery(sample, writeQuery(sample, before, initial));
      expect(problems).toEqual([]);
      const after = changed(sample, initial, patch);
      // −0 is written as 0: no picture tells them apart.
      expect(JSON.stringify(after)).toBe(JSON.stringify(before));
    }),
    { numRuns: 1000 },
  );
});

test("only what differs from the base is written", () => {
  expect(writeQuery(sample, initial, initial)).toBe("");
  expect(writeQuery(sample, { ...initial, t: 0.25, hull: false }, initial)).toBe("t=0.25&hull=0");
  expect(
    writeQuery(
      sample,
      {
        ...initial,
        points: [
          [0, 0],
          [1.5, -2],
        ],
      },
      initial,
    ),
  ).toBe("points=0,0;1.5,-2");
});

test("a value that cannot be read is reported by name, the rest is kept", () => {
  const { patch, problems } = readQuery(sample, "t=0,5&hull=0&n=2.5&points=1,1;2&colour=red&lang=en");
  expect(patch).toEqual({ hull: false });
  expect(problems.map((one) => one.param)).toEqual(["t", "n", "points", "colour"]);
  expect(problems[0]!.problem.en).toContain("0 … 1");
  expect(problems[3]!.problem.de).toContain("gibt es hier nicht");
});

test("values out of range count as unreadable", () => {
  expect(readQuery(sample, "t=1.01").problems).toHaveLength(1);
  expect(readQuery(sample, "t=-0.0001").problems).toHaveLength(1);
  expect(readQuery(sample, "points=0,0;11,0").problems).toHaveLength(1);
});

test("an empty value of a boolean means on", () => {
  expect(readQuery(sample, "hull").patch).toEqual({ hull: true });
  expect(readQuery(sample, "hull=").patch).toEqual({ hull: true });
});

test("no text makes decoding throw", () => {
  const nasty = fc.oneof(
    fc.string(),
    fc.string({ unit: "binary" }),
    fc
      .array(
        fc.tuple(fc.constantFrom(...Object.keys(sample.params), "__proto__", "constructor"), fc.string()),
      )
      .map((entries) => entries.map(([id, text]) => `${id}=${text}`).join("&")),
  );
  fc.assert(
    fc.property(nasty, (text) => {
      const { patch } = readQuery(sample, text);
      const after = changed(sample, initial, patch);
      expect(Object.keys(after).sort()).toEqual(Object.keys(initial).sort());
    }),
    { numRuns: 2000 },
  );
});

test("names of the object prototype are no parameters", () => {
  const { patch, problems } = readQuery(sample, "__proto__=1&toString=1");
  expect(Object.keys(patch)).toEqual([]);
  expect(problems).toHaveLength(2);
});

test("length and count are capped", () => {
  const long = Array.from({ length: 5000 }, () => "1,1").join(";");
  expect(readQuery(sample, `drawing=${long}`).problems).toHaveLength(1);
  expect(splitQuery(Array.from({ length: 5000 }, (_, i) => `a${i}=1`).join("&")).length).toBeLessThanOrEqual(
    64,
  );
});

test("a broken escape is left as it stands", () => {
  expect(splitQuery("a=%E0%A4%A&b=%2C")).toEqual([
    ["a", "%E0%A4%A"],
    ["b", ","],
  ]);
});
