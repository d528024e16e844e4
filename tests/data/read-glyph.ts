import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Blob, Face, Font } from "harfbuzzjs";
import type { GlyphOutline } from "../../src/data/glyph-outline.ts";

interface FontVerter {
  convert(font: Buffer, format: "truetype"): Promise<Buffer>;
}

const require = createRequire(import.meta.url);
const fontverter = require("fontverter") as FontVerter;

/** The file of the page's text font: upright, weight axis, Latin letters. */
const FILE = "@fontsource-variable/source-serif-4/files/source-serif-4-latin-wght-normal.woff2";

/** Reads a letter of the page's own text font, in its default (regular) weight, from the installed package. */
export async function readGlyph(letter: string): Promise<GlyphOutline> {
  const bytes = await fontverter.convert(readFileSync(require.resolve(FILE)), "truetype");
  const face = new Face(new Blob(bytes), 0);
  const font = new Font(face);
  const glyph = font.nominalGlyph(letter.codePointAt(0)!);
  if (glyph === undefined) throw new Error(`the font has no letter "${letter}"`);
  return { letter, unitsPerEm: face.upem, ...asStored(font.glyphToJson(glyph)) };
}

type Step = { readonly type: string; readonly values: readonly number[] };
type Stored = { readonly at: readonly number[]; readonly on: boolean };

/** From the path with every point back to the points that the font stores. */
function asStored(path: readonly Step[]): Pick<GlyphOutline, "points" | "onCurve" | "ends"> {
  const contours: Stored[][] = [];
  for (const { type, values } of path) {
    if (type === "M") contours.push([{ at: values, on: true }]);
    else if (type === "L") contours.at(-1)!.push({ at: values, on: true });
    else if (type === "Q")
      contours.at(-1)!.push({ at: values.slice(0, 2), on: false }, { at: values.slice(2), on: true });
    else if (type !== "Z") throw new Error(`unexpected step "${type}": the font is not TrueType`);
  }
  const stored = contours.map((contour) => withoutImplied(withoutLast(contour)));
  const ends: number[] = [];
  for (const contour of stored) ends.push((ends.at(-1) ?? -1) + contour.length);
  const all = stored.flat();
  return { points: all.map((each) => each.at), onCurve: all.map((each) => each.on), ends };
}

/** A closed contour comes back to its start; the point counts once. */
function withoutLast(contour: Stored[]): Stored[] {
  const [first, last] = [contour[0]!, contour.at(-1)!];
  return first.at.every((x, k) => x === last.at[k]) ? contour.slice(0, -1) : contour;
}

function withoutImplied(contour: Stored[]): Stored[] {
  return contour.filter((point, k) => {
    const before = contour.at(k - 1)!;
    const after = contour[(k + 1) % contour.length]!;
    const middle = point.at.every((x, axis) => x === (before.at[axis]! + after.at[axis]!) / 2);
    return !(point.on && !before.on && !after.on && middle);
  });
}
