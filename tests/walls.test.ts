import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { cruise, type ICruiseOptions, type ICruiseResult } from "dependency-cruiser";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { demos } from "../src/demos/index.ts";
import { code, sources } from "./support/sources.ts";

const config: Pick<ICruiseOptions, "ruleSet"> & { options: ICruiseOptions; forbidden: never[] } =
  createRequire(import.meta.url)("../.dependency-cruiser.cjs");

/** A file that breaks a rule, the line that breaks it, and the rule. */
const BREACHES = [
  ["src/math/a.ts", 'import "../scene/x.ts";', "walls-of-math"],
  ["src/words/a.ts", 'import "../math/x.ts";', "walls-of-words"],
  ["src/data/a.ts", 'import "../scene/x.ts";', "walls-of-data"],
  ["src/data/b.ts", 'import { x } from "../math/x.ts"; x;', "data-takes-types-of-math-only"],
  ["src/scene/a.ts", 'import "../demo/x.ts";', "walls-of-scene"],
  ["src/demo/a.ts", 'import "../demos/x.ts";', "walls-of-demo"],
  ["src/demos/a.ts", 'import "../render/x.ts";', "walls-of-demos"],
  ["src/demos/b.ts", 'import "./x.ts";', "demos-stand-alone"],
  ["src/exercises/a.ts", 'import "../demos/x.ts";', "walls-of-exercises"],
  ["src/exercises/b.ts", 'import "./x.ts";', "demos-stand-alone"],
  ["src/identities/a.ts", 'import "../scene/x.ts";', "walls-of-identities"],
  ["src/render/a.ts", 'import type { x } from "../demo/x.ts"; let y: typeof x;', "walls-of-render"],
  ["src/render/b.ts", 'import "./dom/x.ts";', "svg-tree-knows-no-dom"],
  ["src/player/a.ts", 'import("../demos/x.ts");', "walls-of-player"],
  ["src/player/b.ts", 'import "../site/x.ts";', "walls-of-player"],
  ["src/player/c.ts", 'import "../../lessons/toc.ts";', "walls-of-player"],
  ["src/player/d.ts", 'import "lil-gui";', "only-one-panel"],
  ["src/player/e.ts", 'import "three";', "only-render-three"],
  ["src/player/f.ts", 'import "node:fs";', "node-in-the-build-only"],
  ["src/site/a.ts", 'import "../math/x.ts";', "walls-of-site"],
  ["src/site/b.ts", 'import "../demos/x.ts";', "walls-of-site"],
  ["src/site/c.ts", 'import "katex";', "only-the-build"],
  ["src/build/a.ts", 'import "../player/x.ts";', "walls-of-build"],
  ["src/build/b.ts", 'import "../site/x.ts";', "walls-of-build"],
  ["src/math/b.ts", 'import "katex";', "pure-rooms-need-nothing"],
  ["src/scene/b.ts", 'import "node:fs";', "pure-rooms-need-nothing"],
  ["src/scene/circle-a.ts", 'import { b } from "./circle-b.ts"; export const a = () => b;', "no-circles"],
  ["src/render/c.ts", 'import "./nowhere.ts";', "everything-resolves"],
] as const;

/** What the table allows. */
const ALLOWED = [
  ["src/data/ok.ts", 'import type { x } from "../math/x.ts"; let y: typeof x;'],
  ["src/scene/ok.ts", 'import "../math/x.ts"; import type { x } from "../words/x.ts"; let y: typeof x;'],
  ["src/demos/ok.ts", 'import "../demo/x.ts"; import "../data/x.ts";'],
  ["src/render/three/ok.ts", 'import "three"; import "../../scene/x.ts";'],
  ["src/player/panel-gui.ts", 'import "lil-gui";'],
  ["src/site/ok.ts", 'import "../player/x.ts"; import "../demos/index.ts";'],
  [
    "src/build/ok.ts",
    'import "katex"; import "node:fs"; import "../demos/index.ts"; import "../../lessons/toc.ts";',
  ],
] as const;

const ROOMS = "math words data scene demo demos exercises identities render render/dom player site".split(
  " ",
);

describe("the walls between the rooms", () => {
  const folder = mkdtempSync(join(tmpdir(), "walls-"));
  const write = (file: string, text: string) => {
    mkdirSync(dirname(join(folder, file)), { recursive: true });
    writeFileSync(join(folder, file), text);
  };
  let found: ReadonlySet<string>;

  beforeAll(async () => {
    for (const room of ROOMS) write(`src/${room}/x.ts`, "export const x = 1;\n");
    for (const file of ["src/demos/index.ts", "src/exercises/index.ts", "lessons/toc.ts"])
      write(file, "export {};\n");
    write("src/scene/circle-b.ts", 'import { a } from "./circle-a.ts"; export const b = () => a;');
    for (const name of ["three", "lil-gui", "katex"]) {
      write(`node_modules/${name}/package.json`, JSON.stringify({ name, main: "index.js" }));
      write(`node_modules/${name}/index.js`, "");
    }
    write("package.json", JSON.stringify({ dependencies: { three: "*", "lil-gui": "*", katex: "*" } }));
    for (const [file, text] of [...BREACHES, ...ALLOWED]) write(file, text);
    const { doNotFollow, tsPreCompilationDeps, enhancedResolveOptions } = config.options;
    const { output } = await cruise(
      ["src", "lessons"],
      {
        baseDir: folder,
        validate: true,
        ruleSet: { forbidden: config.forbidden },
        ...(doNotFollow ? { doNotFollow } : {}),
        ...(tsPreCompilationDeps ? { tsPreCompilationDeps } : {}),
      },
      enhancedResolveOptions ?? {},
    );
    const { violations } = (output as ICruiseResult).summary;
    found = new Set(violations.map(({ from, rule }) => `${from}: ${rule.name}`));
  }, 60_000);

  afterAll(() => rmSync(folder, { recursive: true }));

  test.each(BREACHES)("%s with %s breaks a wall", (file, _, rule) => {
    expect([...found]).toContain(`${file}: ${rule}`);
  });

  test.each(ALLOWED)("%s may have %s", (file) => {
    expect([...found].filter((one) => one.startsWith(`${file}:`))).toEqual([]);
  });
});

describe("what no rule about imports sees", () => {
  const pure = sources("src").filter(
    ({ path }) =>
      /^src\/(math|data|words|scene|demo|demos|exercises|identities)\//.test(path) ||
      /^src\/render\/[^/]+$/.test(path),
  );

  test("pure rooms know neither chance nor time nor the console", () => {
    expect(pure.length).toBeGreaterThan(50);
    expect(matches(pure, /\bMath\.random\b|\bDate\b|\bperformance\b|\bconsole\b|\bprocess\b/)).toEqual([]);
  });

  test("no text becomes markup in the browser", () => {
    const browser = sources("src").filter(({ path }) => /^src\/(player|site|render)\//.test(path));
    const ways =
      /\b(inner|outer)HTML\b|insertAdjacentHTML|document\.write|createContextualFragment|setHTMLUnsafe/;
    expect(matches(browser, ways)).toEqual([]);
  });

  test("storage is touched in one module, and by the line that sets the theme before the first paint", () => {
    const all = sources("src");
    const storage = /\b(localStorage|sessionStorage|indexedDB)\b|document\.cookie/;
    expect(matches(all, storage)).toEqual(["src/build/templates/boot.ts", "src/site/storage.ts"]);
  });

  test("a demo is one file and one line of the registry: nothing else names it", () => {
    const ids = Object.keys(demos);
    expect(ids.length).toBeGreaterThan(0);
    for (const id of ids) {
      const named = new RegExp(`["'\`/]${id}["'\`/?]`);
      const elsewhere = sources("src").filter(
        // An identity may have the same name as a demo; an exercise says in which demo it is answered.
        ({ path }) =>
          path !== `src/demos/${id}.ts` &&
          path !== "src/demos/index.ts" &&
          !/^src\/(identities|exercises)\//.test(path),
      );
      expect(matches(elsewhere, named), `"${id}" is named outside of its file`).toEqual([]);
      const lines = code(sources("src/demos").find(({ path }) => path === "src/demos/index.ts")!.text)
        .split("\n")
        .filter((line) => line.includes(`${id}.ts`));
      expect(lines.length, `lines of the registry that name "${id}"`).toBe(1);
    }
  });
});

/** The files whose program, comments aside, matches. */
function matches(files: readonly { path: string; text: string }[], pattern: RegExp): string[] {
  return files.filter(({ text }) => pattern.test(code(text))).map(({ path }) => path);
}
