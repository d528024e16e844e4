import metrics from "katex/src/fontMetricsData.js";
import { describe, expect, test } from "vitest";
import { setLabel } from "../../src/render/set-label.ts";
import { textWidth } from "../../src/render/text-width.ts";
import { symbol, wording } from "../../src/scene/label.ts";

const told = (label: Parameters<typeof setLabel>[0], lang: "de" | "en" = "de") =>
  setLabel(label, lang).runs.map(({ text, font, size, dy }) => `${font} ${text} ${size} ${Math.round(dy)}`);

describe("textWidth", () => {
  const tables = { math: metrics["Math-Italic"], main: metrics["Main-Regular"] } as const;

  test.each(["math", "main"] as const)("%s: widths are those of KaTeX's own metrics", (font) => {
    const letters = font === "math" ? "abcxyzpABCfκαλ" : "0123456789()=+−,;Σ′∞";
    for (const char of letters) {
      const code = String(char.codePointAt(0));
      const width = (tables[font] as Record<string, readonly number[]>)[code]![4]!;
      expect(textWidth(char, font, 1000), char).toBeCloseTo(1000 * width, -0.5);
    }
  });

  test("adds up, scales with the size, and has an answer for any text", () => {
    expect(textWidth("ab", "text", 14)).toBeCloseTo(textWidth("a", "text", 14) + textWidth("b", "text", 14));
    expect(textWidth("Wort", "text", 28)).toBeCloseTo(2 * textWidth("Wort", "text", 14));
    expect(textWidth("語🙂", "text", 10)).toBeCloseTo(10);
    expect(textWidth("", "math", 17)).toBe(0);
  });
});

describe("setLabel", () => {
  test("letters italic, digits upright, sub below the line in 12 pixels", () => {
    expect(told(symbol("c", 2))).toEqual(["math c 17 0", "main 2 12 4"]);
  });

  test("sub and sup stand above each other", () => {
    const { runs } = setLabel(symbol("B", "i", 3), "de");
    expect(runs.map((run) => run.text)).toEqual(["B", "i", "3"]);
    expect(runs[2]!.dx - runs[1]!.dx).toBeLessThan(1);
    expect(runs[1]!.dy).toBeGreaterThan(0);
    expect(runs[2]!.dy).toBeLessThan(0);
  });

  test("numbers as arguments in the reader's notation; in German a semicolon parts them", () => {
    const label = { base: "S", args: [0.5, -0.25] };
    expect(told(label, "de").join(" ")).toContain("(0,5; −0,25)");
    expect(told(label, "en").join(" ")).toContain("(0.5, −0.25)");
    expect(told({ base: "S", args: ["u", "v"] }, "de")).toEqual([
      "math S 17 0",
      "main ( 17 0",
      "math u 17 0",
      "main ,  17 0",
      "math v 17 0",
      "main ) 17 0",
    ]);
  });

  test("primes are raised, a hyphen becomes a minus sign, words stay words", () => {
    expect(told({ base: "p", prime: 2 })).toEqual(["math p 17 0", "main ′′ 12 -7"]);
    expect(told(symbol("t", "i-1"))).toEqual(["math t 17 0", "math i 12 4", "main −1 12 4"]);
    expect(told(wording({ de: "Halb-Kreis", en: "semicircle" }))).toEqual(["text Halb-Kreis 14 0"]);
    expect(told(wording({ de: "Halb-Kreis", en: "semicircle" }), "en")).toEqual(["text semicircle 14 0"]);
  });

  test("the extent holds every run", () => {
    for (const label of [
      symbol("c", 0),
      symbol("B", "i+1", "n−1"),
      { base: "p", prime: 1 as const, args: [0.4] },
    ]) {
      const { runs, width, ascent, descent } = setLabel(label, "de");
      for (const { text, font, size, dx, dy } of runs) {
        expect(dx + textWidth(text, font, size)).toBeLessThanOrEqual(width + 1e-9);
        expect(dy).toBeLessThanOrEqual(descent);
        expect(-dy).toBeLessThanOrEqual(ascent);
      }
    }
  });
});
