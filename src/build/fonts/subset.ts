import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import subsetFont from "subset-font";
import { type Characters, inRange } from "./characters.ts";
import type { Face } from "./faces.ts";

/** A font cut down to what the site shows; null if it shows nothing in it. */
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
    const all = face.display === "block" ? characters.formulas : characters.text;
    const codes = [...all].filter((code) => inRange(code, face.range)).sort((a, b) => a - b);
    if (codes.length === 0) continue;
    cut.push({ face, data: await cutFont(join(root, "node_modules", face.file), cache, face, codes) });
  }
  return cut;
}

async function cutFont(
  file: string,
  cache: string,
  face: Face,
  codes: readonly number[],
): Promise<Uint8Array> {
  const original = readFileSync(file);
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
