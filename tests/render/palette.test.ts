import { describe, expect, test } from "vitest";
import { ROLES } from "../../src/render/roles.ts";
import { forcedPalette, INDEX_COUNT, indexToken, palettes, type Token } from "../../src/render/theme.ts";
import { contrast, distance, EYES, oklab } from "./colour.ts";

const THEMES = ["light", "dark", "print"] as const;
const INDEX = Array.from({ length: INDEX_COUNT }, (_, i) => indexToken(i));
/** Tokens of lettering, and of lines and points that carry meaning. */
const TEXT: Token[] = ["ink", "soft", "lath", "curve", "good", "bad", ...INDEX];
const GRAPHICS: Token[] = [...TEXT, "rest", "polygon"];

describe.each(THEMES)("%s", (theme) => {
  const palette = palettes[theme];

  test.each(TEXT)("lettering in %s is readable on the paper", (token) => {
    expect(contrast(palette[token], palette.paper)).toBeGreaterThanOrEqual(4.5);
  });

  test.each(GRAPHICS)("lines in %s can be made out on the paper", (token) => {
    expect(contrast(palette[token], palette.paper)).toBeGreaterThanOrEqual(3);
  });

  test("running text reaches 7 : 1, also on raised paper", () => {
    expect(contrast(palette.ink, palette.paper)).toBeGreaterThanOrEqual(7);
    expect(contrast(palette.ink, palette.raised)).toBeGreaterThanOrEqual(7);
    expect(contrast(palette.soft, palette.raised)).toBeGreaterThanOrEqual(4.5);
  });

  test.each(Object.keys(EYES))("the index colours differ for %s vision", (eyes) => {
    for (let i = 0; i < INDEX_COUNT; i++) {
      for (let j = 0; j < i; j++) {
        const apart = distance(palette[indexToken(i)], palette[indexToken(j)], eyes);
        // Just noticeable is about 2. Blue and green of the design (0 and 2) are nearest, for the blue-blind.
        const least = eyes === "normal" ? 10 : i === 2 && j === 0 ? 2.9 : 4.7;
        expect(apart, `${i} and ${j}`).toBeGreaterThanOrEqual(least);
      }
    }
  });

  test("no index colour is taken for that of the curve", () => {
    for (const token of INDEX) {
      for (const eyes of Object.keys(EYES)) {
        expect(distance(palette[token], palette.curve, eyes), `${token}, ${eyes}`).toBeGreaterThanOrEqual(
          4.7,
        );
      }
    }
  });

  test("every role's colour and lettering is a colour of the theme", () => {
    for (const { token, text } of Object.values(ROLES)) {
      expect(palette[token]).toMatch(/^#[0-9a-f]{6}$/);
      if (text) expect(palette[text]).toMatch(/^#[0-9a-f]{6}$/);
    }
  });
});

test("an index beyond the palette starts again from the first", () => {
  expect(indexToken(INDEX_COUNT + 3)).toBe(indexToken(3));
  expect(indexToken(-1)).toBe(indexToken(INDEX_COUNT - 1));
});

test("an index has about the same hue in light and in dark", () => {
  const hue = (hex: string) => {
    const [, a, b] = oklab(hex);
    return (Math.atan2(b, a) * 180) / Math.PI;
  };
  for (const token of INDEX) {
    const turn = Math.abs(((hue(palettes.light[token]) - hue(palettes.dark[token]) + 540) % 360) - 180);
    expect(turn, token).toBeLessThan(35);
  }
});

test("forced colours are system colours only, read through the given reader", () => {
  const asked: string[] = [];
  const palette = forcedPalette((name) => {
    asked.push(name);
    return `[${name}]`;
  });
  const words = asked.flatMap((name) => name.match(/[A-Z]\w+/g) ?? []);
  expect(new Set(words)).toEqual(new Set(["Canvas", "CanvasText", "GrayText", "Highlight"]));
  expect(asked.join()).not.toContain("#");
  expect(palette.paper).toBe("[Canvas]");
  expect(palette["index-7"]).toBe("[CanvasText]");
});
