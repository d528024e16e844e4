import { createHash } from "node:crypto";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, test } from "vitest";
import { parts } from "../../lessons/toc.ts";
import { contentSecurityPolicy } from "../../src/build/csp.ts";
import { gatherCharacters, inRange, writeRange } from "../../src/build/fonts/characters.ts";
import { FACES, faceRule } from "../../src/build/fonts/faces.ts";
import { fontCharacters } from "../../src/build/fonts/font-characters.ts";
import { cutFonts } from "../../src/build/fonts/subset.ts";
import { licencesText, packagesOf } from "../../src/build/licences.ts";
import { rootOf } from "../../src/build/pages/page.ts";
import { sourceLines } from "../../src/build/source-lines.ts";

const ROOT = `${import.meta.dirname}/../..`;

test("the course has the fifteen lessons in their order", () => {
  expect(parts.flatMap(({ lessons }) => lessons).join(" ")).toBe(
    "interpolation representations parameter basis-functions lagrange runge bezier hermite continuity splines " +
      "cubic-splines parabolic-blending matrix-form b-splines surfaces",
  );
});

test("the policy allows the inline parts by their hashes and nothing else", () => {
  const hash = (text: string) => createHash("sha256").update(text).digest("base64");
  const policy = contentSecurityPolicy({ scripts: ["boot()"], styles: ["a{}"] });
  expect(policy).toBe(
    `default-src 'none'; script-src 'self' 'sha256-${hash("boot()")}'; style-src 'self' 'sha256-${hash("a{}")}'; ` +
      "style-src-attr 'unsafe-inline'; img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self'; " +
      "media-src 'self' blob:; worker-src 'self' blob:; manifest-src 'self'; frame-src 'self'; base-uri 'none'; " +
      "form-action 'none'; object-src 'none'; require-trusted-types-for 'script'; trusted-types straklatte",
  );
  expect(contentSecurityPolicy({ scripts: [] })).toContain("style-src 'self';");
});

test("the root is as far away as the page is deep", () => {
  expect(["", "de/", "de/bezier/", "embed/glyph/"].map(rootOf)).toEqual(["", "../", "../../", "../../"]);
});

test("fonts hold what is seen in pages and words of scripts, not what is only heard", () => {
  const page = '<p title="ж">Grüße &#x2192; <math><mi>ℵ</mi></math><span>∮</span></p>';
  const { text, formulas } = gatherCharacters([page], ['const a="Größe \\u2265 κ"']);
  const has = (set: ReadonlySet<number>, chars: string) =>
    [...chars].map((char) => set.has(char.codePointAt(0)!));
  expect(has(text, "ü→∮ö≥κaZ0")).toEqual(Array(9).fill(true));
  expect(has(formulas, "∮+0a")).toEqual(Array(4).fill(true));
  expect(has(text, "жℵ")).toEqual([false, false]);
});

test("a face is asked for the characters of its range only", () => {
  expect([0x41, 0xe4, 0x2212, 0x3b1].map((code) => inRange(code, "U+0-FF,U+2212"))).toEqual([
    true,
    true,
    true,
    false,
  ]);
  expect(inRange(0x3b1, "")).toBe(true);
});

test("a range names exactly the characters that a cut font holds", () => {
  expect(writeRange([0x20, 0x21, 0x22, 0x41, 0xe4, 0xe5])).toBe("U+20-22,U+41,U+E4-E5");
  expect([0x21, 0x23, 0x41, 0xe5].map((code) => inRange(code, "U+20-22,U+41,U+E4-E5"))).toEqual([
    true,
    false,
    true,
    true,
  ]);
});

test("a font that lacks the characters asked of it is not shipped, and what is shipped can be read", async () => {
  const faces = FACES.filter(({ family, style }) => family === "Source Sans 3" && style === "normal");
  const set = (chars: string) => new Set([...chars].map((char) => char.codePointAt(0)!));
  const characters = { text: set("aä −ᵤ"), formulas: set("") };
  const cut = await cutFonts(ROOT, faces, characters);
  expect(cut.map(({ face }) => [face.file.includes("-latin-wght"), face.range])).toEqual([
    [true, "U+20,U+61,U+E4,U+2212"],
  ]);
  const cache = mkdtempSync(join(tmpdir(), "fonts-"));
  expect([...(await fontCharacters(cut[0]!.data, cache))].sort((a, b) => a - b)).toEqual([
    0x20, 0x61, 0xe4, 0x2212,
  ]);
  rmSync(cache, { recursive: true });
});

test("text does without a font that comes late, a formula waits for it", () => {
  for (const face of FACES) {
    const display = face.family.startsWith("KaTeX") ? "block" : "optional";
    expect(faceRule(face, "a.woff2")).toContain(`font-display:${display};`);
  }
  expect(FACES.filter(({ embed }) => embed).map(({ family }) => family)).not.toContain("Source Serif 4");
});

const SOURCE = `
export function outer(a: number): number {
  const inner = (b: number) => {
    return b;
  };

  // #region middle
  if (a > 0) {
    a = inner(a);
  }
  // #endregion
  return a;
}
`;

test("lines of a function are its body, moved to the left", () => {
  expect(sourceLines(SOURCE, "inner")).toEqual(["return b;"]);
  expect(sourceLines(SOURCE, "outer")?.slice(0, 2)).toEqual([
    "const inner = (b: number) => {",
    "  return b;",
  ]);
  expect(sourceLines(SOURCE, "outer")?.at(-1)).toBe("return a;");
});

test("lines of a region stand between its marks", () => {
  expect(sourceLines(SOURCE, "middle")).toEqual(["if (a > 0) {", "  a = inner(a);", "}"]);
  expect(sourceLines(SOURCE, "other")).toBeNull();
  expect(sourceLines("// #region open\na();", "open")).toBeNull();
});

test("licences name each package once, and give its own words", () => {
  const files = [
    "/x/node_modules/katex/dist/a.js",
    "/x/node_modules/@a/b/c.js",
    "/x/node_modules/katex/b.js",
    "/x/src/a.ts",
  ];
  expect(packagesOf(files)).toEqual(["@a/b", "katex"]);
  expect(licencesText(ROOT, ["katex", "lil-gui"])).toMatch(/katex [\d.]+ \(MIT\).*Khan Academy.*lil-gui/s);
  expect(() => licencesText(ROOT, ["no-such-package"])).toThrow();
});
