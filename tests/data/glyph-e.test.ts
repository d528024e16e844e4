import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { expect, test } from "vitest";
import { glyphE } from "../../src/data/glyph-e.generated.ts";
import { type GlyphOutline, outlineArcs } from "../../src/data/glyph-outline.ts";
import { readGlyph } from "./read-glyph.ts";

test("the committed outline of e is what the installed font holds (else: npm run data:glyph)", async () => {
  const glyph = await readGlyph("e");
  await expect(moduleText(glyph)).toMatchFileSnapshot("../../src/data/glyph-e.generated.ts");
});

test("the licence beside the outline is the font's own", () => {
  const file = createRequire(import.meta.url).resolve("@fontsource-variable/source-serif-4/LICENSE");
  const ours = readFileSync(new URL("../../src/data/source-serif-4.LICENSE.txt", import.meta.url), "utf8");
  expect(ours).toBe(readFileSync(file, "utf8"));
});

test("the arcs of e close up, join without gaps, and are lines and quadratic curves", () => {
  for (const arcs of outlineArcs(glyphE)) {
    arcs.forEach((arc, k) => {
      const next = arcs[(k + 1) % arcs.length]!;
      expect(arc.controlPoints.at(-1)).toEqual(next.controlPoints[0]);
      expect([2, 3]).toContain(arc.controlPoints.length);
      expect(arc.from.length).toBeGreaterThanOrEqual(2);
    });
  }
});

test("where the font leaves a point out, the two arcs share their tangent", () => {
  const [arcs] = outlineArcs(glyphE);
  let left = 0;
  arcs!.forEach((arc, k) => {
    const next = arcs![(k + 1) % arcs!.length]!;
    const shared = arc.from.filter((i) => next.from.includes(i));
    if (shared.length < 2) return;
    left++;
    const [, b, c] = arc.controlPoints;
    const d = next.controlPoints[1]!;
    expect(c!.map((x, axis) => x - b![axis]!)).toEqual(d.map((x, axis) => x - c![axis]!));
  });
  expect(left).toBe(17);
});

test("points that are all beside the curve make a closed curve through their midpoints", () => {
  const square = [
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
  ];
  const [arcs] = outlineArcs({ points: square, onCurve: [false, false, false, false], ends: [3] });
  expect(arcs!.map((arc) => arc.controlPoints)).toEqual([
    [
      [1, 0],
      [2, 0],
      [2, 1],
    ],
    [
      [2, 1],
      [2, 2],
      [1, 2],
    ],
    [
      [1, 2],
      [0, 2],
      [0, 1],
    ],
    [
      [0, 1],
      [0, 0],
      [1, 0],
    ],
  ]);
});

/** The module as it is committed. */
function moduleText({ letter, unitsPerEm, points, onCurve, ends }: GlyphOutline): string {
  const rows = points.map(([x, y], i) => `    [${x}, ${y}], // ${i}${onCurve[i] ? " on the curve" : ""}`);
  return `// Written by "npm run data:glyph" from the font Source Serif 4 (@fontsource-variable/source-serif-4), regular weight.
// The font is under the SIL Open Font License 1.1: source-serif-4.LICENSE.txt.
import type { GlyphOutline } from "./glyph-outline.ts";

export const glyphE: GlyphOutline = {
  letter: ${JSON.stringify(letter)},
  unitsPerEm: ${unitsPerEm},
  points: [
${rows.join("\n")}
  ],
  onCurve: [
    ${onCurve.join(", ")},
  ],
  ends: ${JSON.stringify(ends)},
};
`;
}
