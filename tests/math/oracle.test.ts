import { expect, test } from "vitest";
import { differences, readOracles, runCase } from "./oracle.ts";

const tolerance = { abs: 1e-9, rel: 1e-6 };
const misses = (actual: unknown, expected: unknown) => differences(actual, expected, tolerance).length;

test("numbers pass within abs + rel · |expected| only", () => {
  expect(misses(1000.001, 1000)).toBe(0);
  expect(misses(1000.0011, 1000)).toBe(1);
  expect(misses(1e-9, 0)).toBe(0);
  expect(misses(Number.NaN, 0)).toBe(1);
  expect(misses(Number.POSITIVE_INFINITY, 0)).toBe(1);
  expect(misses("1", 1)).toBe(1);
});

test("null stands for what does not exist: null, undefined or an error, never a number", () => {
  for (const absent of [null, undefined, new RangeError("none")]) expect(misses(absent, null)).toBe(0);
  for (const present of [0, Number.NaN, [], false]) expect(misses(present, null)).toBe(1);
});

test("arrays need the same length; objects every expected key; the rest equality", () => {
  expect(misses([1, 2], [1, 2])).toBe(0);
  expect(misses([1, 2, 3], [1, 2])).toBe(1);
  expect(misses({ a: 1, more: 2 }, { a: 1 })).toBe(0);
  expect(misses({}, { a: 1, b: 2 })).toBe(2);
  expect(misses(true, true) + misses("x", "x")).toBe(0);
  expect(misses(false, true) + misses("x", "y") + misses(1, true)).toBe(3);
});

test("an unknown op fails; an undefined problem wants an error or no result", () => {
  const adapter = {
    throws: () => {
      throw new RangeError("nodes[1]: repeated");
    },
    breaks: () => {
      throw new TypeError("a bug");
    },
    answers: () => 1,
    silent: () => null,
  };
  const run = (op: string, expected: unknown) =>
    runCase(adapter, { name: op, input: { op }, expect: expected, tolerance });
  const none = { undefined: "repeated nodes" };
  expect(run("missing", 1)).toHaveLength(1);
  expect(run("toString", 1)).toHaveLength(1);
  expect(run("throws", none)).toEqual([]);
  expect(run("silent", none)).toEqual([]);
  expect(run("answers", none)).toHaveLength(1);
  expect(run("throws", 1)).toHaveLength(1);
  expect(run("answers", 1)).toEqual([]);
  expect(() => run("breaks", none)).toThrow(TypeError);
});

test("a folder without data is an error", () => {
  expect(() => readOracles("tests/math/oracles")).toThrow(/no \*\.json/);
});
