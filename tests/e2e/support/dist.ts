import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";

export const DIST = join(import.meta.dirname, "../../../dist");

if (!existsSync(DIST)) throw new Error("there is no dist/: run `npm run build` before the browser tests");

/** All files of the build, as paths below dist/. */
export const files: readonly string[] = readdirSync(DIST, { recursive: true, withFileTypes: true })
  .filter((entry) => entry.isFile())
  .map((entry) => relative(DIST, join(entry.parentPath, entry.name)).replaceAll("\\", "/"))
  .sort();

/** The documents, as addresses below the root: "", "de/", "de/bezier/", … */
export const pages: readonly string[] = files
  .filter((file) => /(^|\/)index\.html$/.test(file))
  .map((file) => file.slice(0, -"index.html".length));

/** The lessons in both languages. */
export const lessons: readonly string[] = pages.filter((page) =>
  readFile(`${page}index.html`).includes('<body class="lesson-page">'),
);

export function readFile(file: string): string {
  return readFileSync(join(DIST, file), "utf8");
}
