import { describe, expect, test } from "vitest";
import {
  checkAscending,
  checkDistinct,
  checkInteger,
  checkInterval,
  checkNonDecreasing,
  checkNumber,
  checkNumbers,
  checkPoint,
  checkPoints,
  checkPositive,
  checkSameLength,
  checkWeights,
} from "../../src/math/check.ts";
import type { Point } from "../../src/math/index.ts";

/** The message of the RangeError that a call throws. */
function complaint(call: () => unknown): string {
  try {
    call();
  } catch (error) {
    if (error instanceof RangeError) return error.message;
    throw error;
  }
  return "none";
}

describe("numbers", () => {
  test("finite", () => {
    for (const value of [0, -0, -1.5, 1e308]) expect(complaint(() => checkNumber("t", value))).toBe("none");
    expect(complaint(() => checkNumber("t", Number.NaN))).toBe("t: expected a finite number, got NaN");
    expect(complaint(() => checkNumber("t", -Infinity))).toBe("t: expected a finite number, got -Infinity");
    expect(complaint(() => checkNumber("t", "1" as never))).toBe('t: expected a finite number, got "1"');
    expect(complaint(() => checkNumber("t", undefined as never))).toBe(
      "t: expected a finite number, got undefined",
    );
  });

  test("positive", () => {
    expect(complaint(() => checkPositive("accuracy", 1e-300))).toBe("none");
    for (const value of [0, -1, Number.NaN, Infinity]) {
      expect(complaint(() => checkPositive("accuracy", value))).toBe(
        `accuracy: expected a positive finite number, got ${value}`,
      );
    }
  });

  test("whole, within a range", () => {
    for (const value of [2, 3, 5]) expect(complaint(() => checkInteger("n", value, 2, 5))).toBe("none");
    for (const value of [1, 6, 2.5, Number.NaN, Infinity]) {
      expect(complaint(() => checkInteger("n", value, 2, 5))).toBe(
        `n: expected a whole number from 2 to 5, got ${value}`,
      );
    }
    expect(complaint(() => checkInteger("n", 1e9, 0))).toBe("none");
    expect(complaint(() => checkInteger("n", -1, 0))).toBe(
      "n: expected a whole number of at least 0, got -1",
    );
  });

  test("lists", () => {
    expect(complaint(() => checkNumbers("ts", [1]))).toBe("none");
    expect(complaint(() => checkNumbers("ts", new Float64Array([1, 2])))).toBe("none");
    expect(complaint(() => checkNumbers("ts", [], 0))).toBe("none");
    expect(complaint(() => checkNumbers("ts", []))).toBe("ts: expected at least 1 number, got none");
    expect(complaint(() => checkNumbers("ts", [1, 2], 3))).toBe("ts: expected at least 3 numbers, got 2");
    expect(complaint(() => checkNumbers("ts", [0, Number.NaN]))).toBe(
      "ts[1]: expected a finite number, got NaN",
    );
    expect(complaint(() => checkNumbers("ts", 5 as never))).toBe("ts: expected a list of numbers, got 5");
  });
});

describe("points", () => {
  test("one point", () => {
    expect(complaint(() => checkPoint("p", [1]))).toBe("none");
    expect(complaint(() => checkPoint("p", [1, 2], 2))).toBe("none");
    expect(complaint(() => checkPoint("p", []))).toBe("p: expected at least one coordinate, got []");
    expect(complaint(() => checkPoint("p", [1, 2], 3))).toBe("p: expected 3 coordinates, got [1, 2]");
    expect(complaint(() => checkPoint("p", [1, 2], 1))).toBe("p: expected 1 coordinate, got [1, 2]");
    expect(complaint(() => checkPoint("p", [1, Infinity]))).toBe(
      "p[1]: expected a finite number, got Infinity",
    );
    expect(complaint(() => checkPoint("p", 3 as never))).toBe(
      "p: expected a point (a list of coordinates), got 3",
    );
  });

  test("several points, whose dimension is returned", () => {
    expect(checkPoints("c", [[1, 2, 3]])).toBe(3);
    expect(checkPoints("c", [[1], [2]], 2)).toBe(1);
    expect(checkPoints("c", [], 0, 2)).toBe(2);
    expect(complaint(() => checkPoints("c", []))).toBe("c: expected at least 1 point, got none");
    expect(complaint(() => checkPoints("c", [[1, 2]], 2))).toBe("c: expected at least 2 points, got 1");
    expect(complaint(() => checkPoints("c", [[1, 2], [3]]))).toBe("c[1]: expected 2 coordinates, got [3]");
    expect(complaint(() => checkPoints("c", [[1, 2]], 1, 3))).toBe(
      "c[0]: expected 3 coordinates, got [1, 2]",
    );
    expect(
      complaint(() =>
        checkPoints("c", [
          [0, 0],
          [0, 0],
          [1, Number.NaN],
        ]),
      ),
    ).toBe("c[2][1]: expected a finite number, got NaN");
    expect(complaint(() => checkPoints("c", [[1], undefined as unknown as Point]))).toBe(
      "c[1]: expected a point (a list of coordinates), got undefined",
    );
    expect(complaint(() => checkPoints("c", null as never))).toBe("c: expected a list of points, got null");
  });
});

describe("order", () => {
  test("distinct", () => {
    expect(complaint(() => checkDistinct("nodes", [3, 1, 2]))).toBe("none");
    expect(complaint(() => checkDistinct("nodes", [3, 1, 2, 1]))).toBe(
      "nodes[3]: expected a value different from nodes[1], got 1",
    );
    expect(complaint(() => checkDistinct("nodes", [0, -0]))).toMatch(/^nodes\[1\]/);
    expect(complaint(() => checkDistinct("nodes", [1], 2))).toMatch(/^nodes: expected at least 2/);
  });

  test("ascending", () => {
    expect(complaint(() => checkAscending("x", [1, 2, 3]))).toBe("none");
    expect(complaint(() => checkAscending("x", [1, 2, 2]))).toBe(
      "x[2]: expected a number greater than x[1] = 2, got 2",
    );
    expect(complaint(() => checkAscending("x", [1, 0]))).toBe(
      "x[1]: expected a number greater than x[0] = 1, got 0",
    );
    expect(complaint(() => checkAscending("x", [], 1))).toMatch(/^x: expected at least 1 number/);
  });

  test("not descending", () => {
    expect(complaint(() => checkNonDecreasing("knots", [0, 0, 1, 1]))).toBe("none");
    expect(complaint(() => checkNonDecreasing("knots", [0, 1, 0.5]))).toBe(
      "knots[2]: expected a number of at least knots[1] = 1, got 0.5",
    );
    expect(complaint(() => checkNonDecreasing("knots", [0], 2))).toMatch(/^knots: expected at least 2/);
  });

  test("intervals", () => {
    expect(complaint(() => checkInterval("domain", [0, 1]))).toBe("none");
    expect(complaint(() => checkInterval("domain", [1, 1]))).toMatch(
      /^domain\[1\]: expected a number greater/,
    );
    expect(complaint(() => checkInterval("domain", [1] as never))).toBe(
      "domain: expected an interval [a, b], got [1]",
    );
    expect(complaint(() => checkInterval("domain", 1 as never))).toBe(
      "domain: expected an interval [a, b], got 1",
    );
  });
});

test("lists that belong to each other", () => {
  expect(complaint(() => checkSameLength("values", [1, 2], "nodes", [3, 4]))).toBe("none");
  expect(complaint(() => checkSameLength("values", [1], "nodes", [3, 4]))).toBe(
    "values: expected 2 entries, one for each of nodes, got 1",
  );
});

test("weights", () => {
  expect(complaint(() => checkWeights("weights", [0, -1], 2))).toBe("none");
  expect(complaint(() => checkWeights("weights", [1, 1], 3))).toBe(
    "weights: expected 3 weights, one for each control point, got 2",
  );
  expect(complaint(() => checkWeights("weights", [0, 0], 2))).toBe(
    "weights: expected at least one weight other than 0, got [0, 0]",
  );
  expect(complaint(() => checkWeights("weights", [1, Number.NaN], 2))).toMatch(/^weights\[1\]/);
});
