import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import type { Rolldown } from "vite";
import type { Characters } from "./characters.ts";
import { FACES, type Face, faceRule } from "./faces.ts";
import { cutFonts } from "./subset.ts";

/** The style sheet that names the fonts of a kind of page, and the fonts that its first lines need. */
export interface FontSheet {
  readonly sheet: string;
  readonly first: readonly string[];
}

export interface FontSheets {
  readonly page: FontSheet;
  readonly embed: FontSheet;
}

/** Writes fonts, their style sheets and their licences into the bundle. */
export async function emitFonts(
  context: Rolldown.PluginContext,
  root: string,
  characters: Characters,
): Promise<FontSheets> {
  const written: { readonly face: Face; readonly fileName: string }[] = [];
  for (const { face, data } of await cutFonts(root, FACES, characters)) {
    const id = context.emitFile({ type: "asset", name: basename(face.file), source: data });
    written.push({ face, fileName: context.getFileName(id) });
  }
  for (const [name, file] of licences(FACES.map(({ file }) => file))) {
    const source = readFileSync(join(root, "node_modules", file, "LICENSE"));
    context.emitFile({ type: "asset", fileName: `assets/licence-${name}.txt`, source });
  }
  const sheet = (name: string, fonts: typeof written): FontSheet => {
    const rules = fonts.map(({ face, fileName }) => faceRule(face, basename(fileName)));
    const id = context.emitFile({ type: "asset", name, source: `${rules.join("\n")}\n` });
    const first = fonts.filter(({ face }) => face.first).map(({ fileName }) => fileName);
    return { sheet: context.getFileName(id), first };
  };
  const ofEmbeds = written.filter(({ face }) => face.embed);
  return { page: sheet("fonts.css", written), embed: sheet("fonts-embed.css", ofEmbeds) };
}

/** The packages the fonts come from, by the name of their licence's file. */
function licences(files: readonly string[]): Map<string, string> {
  return new Map(
    files.map((file) => {
      const parts = file.split("/");
      const folder = file.startsWith("@") ? parts.slice(0, 2) : parts.slice(0, 1);
      return [folder.at(-1)!, folder.join("/")];
    }),
  );
}
