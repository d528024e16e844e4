import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { build } from "vite";
import { afterAll, beforeAll, expect, test } from "vitest";

// The package is built, packed, and installed in an empty project that has nothing else and no network.
const folder = mkdtempSync(join(tmpdir(), "straklatte-math-"));
const project = join(folder, "project");
const npm = (args: string[], cwd: string): string =>
  execFileSync("npm", [...args, "--offline", "--no-audit", "--no-fund", "--silent"], {
    cwd,
    encoding: "utf8",
    shell: process.platform === "win32",
  });

beforeAll(() => {
  execFileSync(process.execPath, ["src/build/math-package.mjs", join(folder, "package")]);
  npm(["pack", "./package", "--pack-destination", folder], folder);
  const tarball = readdirSync(folder).find((name) => name.endsWith(".tgz"))!;
  mkdirSync(project);
  writeFileSync(
    join(project, "package.json"),
    JSON.stringify({ name: "empty", private: true, type: "module" }),
  );
  npm(["install", join(folder, tarball)], project);
}, 180_000);

afterAll(() => rmSync(folder, { recursive: true, force: true }));

test("Node imports it", () => {
  writeFileSync(
    join(project, "use.js"),
    `import { bezierPoint, arclength, bezierCurve } from "straklatte-math";
     const b = [[0, 0], [1, 2], [3, 2], [4, 0]];
     console.log(JSON.stringify([bezierPoint(b, 0.5), arclength(bezierCurve([[0, 0], [3, 4]]), 1e-9)]));`,
  );
  const [point, length] = JSON.parse(
    execFileSync(process.execPath, ["use.js"], { cwd: project, encoding: "utf8" }),
  );
  expect(point).toEqual([2, 1.5]);
  expect(length).toBeCloseTo(5, 9);
});

test("it holds what the sources export, and nothing but itself", () => {
  const installed = join(project, "node_modules", "straklatte-math");
  const files = readdirSync(installed);
  const sources = readdirSync("src/math").filter((name) => name.endsWith(".ts"));
  const modules = sources.flatMap((name) => [name.replace(/\.ts$/, ".js"), name.replace(/\.ts$/, ".d.ts")]);
  expect(files.sort()).toEqual([...modules, "LICENSE", "README.md", "package.json"].sort());
  for (const file of files.filter((name) => /\.js$|\.d\.ts$/.test(name))) {
    const imports = [...readFileSync(join(installed, file), "utf8").matchAll(/(?:from|import) "([^"]+)"/g)];
    for (const [, specifier] of imports) expect(specifier).toMatch(/^\.\/[\w-]+\.js$/);
  }
  const { dependencies, sideEffects, version } = JSON.parse(
    readFileSync(join(installed, "package.json"), "utf8"),
  );
  expect(dependencies).toBeUndefined();
  expect(sideEffects).toBe(false);
  expect(version).toBe(JSON.parse(readFileSync("package.json", "utf8")).version);
});

test("its types are found and checked", () => {
  writeFileSync(
    join(project, "typed.ts"),
    `import { bezierPoint, type Point } from "straklatte-math";
     export const point: Point = bezierPoint([[0, 0], [1, 2]], 0.5);
     // @ts-expect-error a parameter is a number
     bezierPoint([[0, 0]], "half");`,
  );
  const tsc = resolve("node_modules/typescript/bin/tsc");
  const options = ["--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "typed.ts"];
  execFileSync(process.execPath, [tsc, ...options], { cwd: project, stdio: "inherit" });
}, 120_000);

test("a bundle holds what it uses and nothing else", async () => {
  const bundle = async (code: string): Promise<string> => {
    writeFileSync(join(project, "entry.js"), code);
    const result = await build({
      root: project,
      configFile: false,
      logLevel: "silent",
      build: { write: false, lib: { entry: "entry.js", formats: ["es"] }, target: "es2022", minify: true },
    });
    return (Array.isArray(result) ? result[0]! : (result as never as { output: { code: string }[] }))
      .output[0]!.code!;
  };
  const nothing = await bundle(`import "straklatte-math";`);
  expect(nothing.trim().length).toBeLessThan(20);
  const point = await bundle(`export { bezierPoint } from "straklatte-math";`);
  expect(point).toContain("controlPoints");
  expect(point.length).toBeLessThan(2500);
  const whole = await bundle(`export * from "straklatte-math";`);
  expect(whole.length).toBeGreaterThan(10 * point.length);
}, 120_000);
