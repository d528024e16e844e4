import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { Blob, Face } from "harfbuzzjs";

interface FontVerter {
  convert(font: Uint8Array, format: "truetype"): Promise<Uint8Array>;
}

/** The characters that a font has, by code; kept in the cache folder, since unpacking a font takes its time. */
export async function fontCharacters(font: Uint8Array, cache: string): Promise<ReadonlySet<number>> {
  const kept = join(cache, `${createHash("sha256").update(font).digest("hex").slice(0, 24)}.json`);
  if (!existsSync(kept)) {
    const fontverter = createRequire(import.meta.url)("fontverter") as FontVerter;
    const face = new Face(new Blob(await fontverter.convert(font, "truetype")), 0);
    writeFileSync(kept, JSON.stringify([...face.collectUnicodes()]));
  }
  return new Set(JSON.parse(readFileSync(kept, "utf8")) as number[]);
}
