import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import subsetFont from "subset-font";
import { type Characters, inRange, writeRange } from "./characters.ts";
import type { Face } from "./faces.ts";
import { fontCharacters } from "./font-characters.ts";

/** A font cut down to what the site shows, its `range` to what it still holds. */
export interface CutFont {
  readonly face: Face;
  readonly data: Uint8Array;
}

/** Small caps, swashes and the like cost more than the letters; these are what text and numbers use. */
const FEATURES = [
  "kern",
  "liga",
  "clig",
  "calt",
  "ccmp",
  "locl",
  "mark",
  "mkmk",
  "lnum",
  "onum",
  "pnum",
  "tnum",
];

/**
 * Cuts fonts down to characters and weights. Results are kept in `node_modules/.cache`, so that a rebuild
 * only pays for what changed.
 */
export async function cutFonts(
  root: string,
  faces: readonly Face[],
  characters: Characters,
): Promise<CutFont[]> {
  const cache = join(root, "node_modules/.cache/straklatte/fonts");
  mkdirSync(cache, { recursive: true });
  const cut: CutFont[] = [];
  for (const face of faces) {
    const original = readFileSync(join(root, "node_modules", face.file));
    const has = await fontCharacters(original, cache);
    const all = face.display === "block" ? characters.formulas : characters.text;
    const codes = [...all].filter((code) => has.has(code) && inRange(code, face.range)).sort((a, b) => a - b);
    // A space alone is no reason to ship a font, and browsers refuse one without any letter.
    if (codes.every((code) => code <= 32)) continue;
    const data = await cutFont(original, cache, face, codes);
    cut.push({ face: face.range ? { ...face, range: writeRange(codes) } : face, data });
  }
  return cut;
}

async function cutFont(
  original: Uint8Array,
  cache: string,
  face: Face,
  codes: readonly number[],
): Promise<Uint8Array> {
  const key = createHash("sha256")
    .update(original)
    .update(JSON.stringify([codes, face.weights, FEATURES]))
    .digest("hex")
    .slice(0, 24);
  const kept = join(cache, `${key}.woff2`);
  if (existsSync(kept)) return readFileSync(kept);
  const data = await subsetFont(original, String.fromCodePoint(...codes), {
    targetFormat: "woff2",
    keepFeatures: FEATURES,
    noHinting: true,
    ...(face.weights ? { variationAxes: { wght: { min: face.weights[0], max: face.weights[1] } } } : {}),
  });
  writeFileSync(kept, data);
  return data;
}
