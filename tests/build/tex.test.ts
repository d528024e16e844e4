import { describe, expect, test } from "vitest";
import { readPicture } from "../../src/build/tex/live-number.ts";
import { readTex, writeTex } from "../../src/build/tex/nodes.ts";
import { bareTex, plainTex, sayTex } from "../../src/build/tex/say-tex.ts";

describe("TeX taken apart", () => {
  test.each(["a_{i}^n", "\\frac{a}{b}", "\\\\[3pt] x", "{a{b}c", "a}b", "\\{x\\}", " a  b\n"])(
    "%s is written as it was",
    (tex) => {
      expect(writeTex(readTex(tex))).toBe(tex);
    },
  );
});

describe("symbols as they are spoken", () => {
  test.each([
    ["c_1", "c 1", "c 1"],
    ["B_2^3", "B 2 3", "B 2 3"],
    ["(1-t)^3", "(1 − t) hoch 3", "(1 − t) to the power 3"],
    ["p'(0)", "p Strich (0)", "p prime (0)"],
    ["\\tfrac{1}{2}", "1 durch 2", "1 over 2"],
    ["\\lambda", "lambda", "lambda"],
  ])("%s", (tex, de, en) => {
    expect(sayTex(tex, "de")).toBe(de);
    expect(sayTex(tex, "en")).toBe(en);
  });
});

test("ties and live numbers leave no trace in what is copied", () => {
  expect(plainTex("a + \\tie{p}{\\frac{x}{2}} = \\live{t}{0.0}")).toBe("a + \\frac{x}{2} = ");
});

test("formulas are compared without spaces and without what hangs below", () => {
  expect(bareTex("\\underbrace{\\tie{w}{(1-t)^{2}}}_{\\live{w}{0.0}}\\, c_0 \\quad")).toBe("(1-t)^{2}c_0");
  expect(bareTex("a - b")).not.toBe(bareTex("a + b"));
  expect(bareTex("x^{12}")).not.toBe(bareTex("x^12"));
});

test("a picture of a number has places for sign, digits and decimals", () => {
  expect(readPicture("-0.00")).toEqual({ digits: 2, widest: "−0.00" });
  expect(readPicture("00")).toEqual({ digits: 0, widest: "00" });
  for (const wrong of ["", "1.0", "0,0", "--0", "0."]) expect(readPicture(wrong)).toBeNull();
});
