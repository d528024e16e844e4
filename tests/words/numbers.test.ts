import { expect, test } from "vitest";
import { formatNumber, formatPoint, parseNumber } from "../../src/words/numbers.ts";

test("numbers follow the language and carry a real minus sign", () => {
  expect(formatNumber(-0.5, "de")).toBe("\u22120,5");
  expect(formatNumber(-0.5, "en")).toBe("\u22120.5");
  expect(formatNumber(1234.5, "de")).toBe("1234,5");
  expect(formatNumber(0.4, "de", 2, true)).toBe("0,40");
});

test("what rounds to zero is zero, without a sign", () => {
  expect(formatNumber(-0.001, "en")).toBe("0");
  expect(formatNumber(-0, "en", 1, true)).toBe("0.0");
});

test("what is not a number is a dash", () => {
  expect(formatNumber(Number.NaN, "de")).toBe("–");
  expect(formatNumber(Number.POSITIVE_INFINITY, "de")).toBe("–");
});

test("points separate with a semicolon where the comma is taken", () => {
  expect(formatPoint([0.5, 2], "de")).toBe("(0,5; 2)");
  expect(formatPoint([0.5, 2], "en")).toBe("(0.5, 2)");
});

test.each([
  ["0,5", 0.5],
  ["0.5", 0.5],
  [" \u22121,25 ", -1.25],
  ["3.", 3],
  [",5", 0.5],
  ["1e-3", 0.001],
  ["", null],
  ["1,2,3", null],
  ["0x10", null],
  ["Infinity", null],
])("a typed %j is read as %j", (text, value) => {
  expect(parseNumber(text)).toBe(value);
});
