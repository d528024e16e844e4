import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import type { Rolldown } from "vite";
import type { Characters } from "./characters.ts";
import { FACES, faceRule } from "./faces.ts";
import { cutFonts } from "./subset.ts";

/** The style sheets that name the fonts, for each kind of page. */
export interface FontSheets {
  readonly page: string;
  readonly embed: string;
}

/** Writes fonts, their style sheets and their licences into the bundle. */
export async function emitFonts(
  context: Rolldown.PluginContext,
  root: string,
  characters: Characters,
): Promise<FontSheets> {
  const rules: { readonly embed: boolean; readonly css: string }[] = [];
  for (const { face, data } of await cutFonts(root, FACES, characters)) {
    const id = context.emitFile({ type: "asset", name: basename(face.file), source: data });
    rules.push({ embed: face.embed, css: faceRule(face, basename(context.getFileName(id))) });
  }
  for (const [name, file] of licences(FACES.map(({ file }) => file))) {
    const source = readFileSync(join(root, "node_modules", file, "LICENSE"));
    context.emitFile({ type: "asset", fileName: `assets/licence-${name}.txt`, source });
  }
  const sheet = (name: string, css: readonly string[]) =>
    context.getFileName(context.emitFile({ type: "asset", name, source: `${css.join("\n")}\n` }));
  return {
    page: sheet(
      "fonts.css",
      rules.map(({ css }) => css),
    ),
    embed: sheet(
      "fonts-embed.css",
      rules.filter(({ embed }) => embed).map(({ css }) => css),
    ),
  };
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
