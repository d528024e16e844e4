import { crc32, inflateSync } from "node:zlib";
import fc from "fast-check";
import { expect, test } from "vitest";
import { LEVELS, levelOf, mapColour, NO_VALUE } from "../../src/render/colour-map.ts";
import { pngUrl } from "../../src/render/png.ts";
import { contrast } from "./colour.ts";

/** Reads a PNG the way any viewer does: every chunk with its check sum. */
function decode(url: string) {
  expect(url).toMatch(/^data:image\/png;base64,/);
  const file = Buffer.from(url.slice(url.indexOf(",") + 1), "base64");
  expect([...file.subarray(0, 8)]).toEqual([137, 80, 78, 71, 13, 10, 26, 10]);
  const chunks: Record<string, Buffer> = {};
  for (let at = 8; at < file.length; ) {
    const length = file.readUInt32BE(at);
    const name = file.toString("latin1", at + 4, at + 8);
    chunks[name] = file.subarray(at + 8, at + 8 + length);
    expect(file.readUInt32BE(at + 8 + length), name).toBe(crc32(file.subarray(at + 4, at + 8 + length)));
    at += 12 + length;
  }
  expect(chunks.IEND).toHaveLength(0);
  const [width, height] = [chunks.IHDR!.readUInt32BE(0), chunks.IHDR!.readUInt32BE(4)];
  expect([...chunks.IHDR!.subarray(8)]).toEqual([8, 3, 0, 0, 0]);
  const raw = inflateSync(chunks.IDAT!);
  expect(raw).toHaveLength(height * (width + 1));
  const filters = Array.from({ length: height }, (_, row) => raw[row * (width + 1)]);
  expect(filters.every((filter) => filter === 0)).toBe(true);
  const pixels = Array.from({ length: width * height }, (_, i) => {
    const row = Math.floor(i / width);
    const level = raw[row * (width + 1) + 1 + (i % width)]!;
    return [...chunks.PLTE!.subarray(3 * level, 3 * level + 3), chunks.tRNS![level]!];
  });
  return { width, height, pixels };
}

test("any raster reads back as the colours of its levels; no value is transparent", () => {
  const raster = fc
    .tuple(fc.integer({ min: 1, max: 40 }), fc.integer({ min: 1, max: 40 }))
    .chain(([columns, rows]) =>
      fc.tuple(
        fc.constant(columns),
        fc.constant(rows),
        fc.uint8Array({ minLength: columns * rows, maxLength: columns * rows }),
      ),
    );
  fc.assert(
    fc.property(
      raster,
      fc.constantFrom("sequential" as const, "diverging" as const),
      ([columns, rows, levels], map) => {
        const { width, height, pixels } = decode(pngUrl(columns, rows, levels, map));
        expect([width, height]).toEqual([columns, rows]);
        levels.forEach((level, i) => {
          if (level === NO_VALUE) expect(pixels[i]![3]).toBe(0);
          else expect(pixels[i]).toEqual([...mapColour(map, level), 255]);
        });
      },
    ),
    { numRuns: 25 },
  );
});

test("a raster of more than one block", () => {
  const levels = Uint8Array.from({ length: 300 * 300 }, (_, i) => i % LEVELS);
  const { pixels } = decode(pngUrl(300, 300, levels, "sequential"));
  expect(pixels.at(-1)).toEqual([...mapColour("sequential", (300 * 300 - 1) % LEVELS), 255]);
});

test("values become levels: ends, middle, beyond, none", () => {
  expect(levelOf(2, [2, 6])).toBe(0);
  expect(levelOf(6, [2, 6])).toBe(LEVELS - 1);
  expect(levelOf(4, [2, 6])).toBe((LEVELS - 1) / 2);
  expect(levelOf(-9, [2, 6])).toBe(0);
  expect(levelOf(1e9, [2, 6])).toBe(LEVELS - 1);
  expect(levelOf(Number.NaN, [2, 6])).toBe(NO_VALUE);
  expect(levelOf(Number.POSITIVE_INFINITY, [2, 6])).toBe(NO_VALUE);
  expect(levelOf(3, [3, 3])).toBe((LEVELS - 1) / 2);
});

const hex = (rgb: readonly number[]) => `#${rgb.map((c) => c.toString(16).padStart(2, "0")).join("")}`;
const lightness = (map: "sequential" | "diverging", level: number) =>
  contrast(hex(mapColour(map, level)), "#000000");

test("the sequential map grows lighter from end to end, so that it reads without colour", () => {
  for (let level = 1; level < LEVELS; level++) {
    expect(lightness("sequential", level)).toBeGreaterThan(lightness("sequential", level - 1) * 0.999);
  }
  expect(lightness("sequential", LEVELS - 1) / lightness("sequential", 0)).toBeGreaterThan(8);
});

test("the diverging map is lightest in the middle and about as dark at both ends", () => {
  const middle = (LEVELS - 1) / 2;
  for (let k = 1; k <= middle; k++) {
    expect(lightness("diverging", middle - k)).toBeLessThan(lightness("diverging", middle - k + 1) * 1.001);
    expect(lightness("diverging", middle + k)).toBeLessThan(lightness("diverging", middle + k - 1) * 1.001);
  }
  expect(lightness("diverging", 0) / lightness("diverging", LEVELS - 1)).toBeGreaterThan(0.7);
  expect(lightness("diverging", 0) / lightness("diverging", LEVELS - 1)).toBeLessThan(1.4);
});
