import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createServer, type ViteDevServer } from "vite";
import { afterAll, beforeAll, describe, expect, test } from "vitest";
import { straklatte } from "../../src/build/plugin.ts";
import { demos } from "../../src/demos/index.ts";

/** A copy of the project, without history, with lessons of the test's own. */
const root = mkdtempSync(join(tmpdir(), "straklatte-"));
const PROJECT = join(import.meta.dirname, "../..");
const demo = Object.keys(demos)[0]!;

const write = (file: string, text: string) => {
  mkdirSync(join(root, file, ".."), { recursive: true });
  writeFileSync(join(root, file), text);
};

const lesson = (text: string) =>
  `---\ntitle: One\nlead: Lead\nminutes: 5\ngoals:\n- a\n---\n\n## A {#a}\n\n${text}\n\n::: demo ${demo} {#fig}\nCaption.\n:::\n`;

beforeAll(() => {
  for (const entry of ["src", "public", "index.html", "vite.config.ts", "package.json", "lessons/toc.ts"]) {
    cpSync(join(PROJECT, entry), join(root, entry), { recursive: true });
  }
  for (const file of [
    "tsconfig.base.json",
    "tsconfig.pure.json",
    "tsconfig.browser.json",
    "tsconfig.node.json",
  ]) {
    cpSync(join(PROJECT, file), join(root, file));
  }
  symlinkSync(join(PROJECT, "node_modules"), join(root, "node_modules"), "dir");
});

afterAll(() => rmSync(root, { recursive: true }));

test("mistakes in the lessons stop the build, each with file, line and remedy", () => {
  const wrong = [
    "$\\nonsense$ and [x](#nowhere)",
    `::: demo ${demo}x {#one}`,
    "C",
    ":::",
    `::: demo ${demo} {#two nonsense=1}`,
    "C",
    ":::",
  ].join("\n");
  write("lessons/bezier/de.md", lesson(wrong));
  write("lessons/bezier/en.md", lesson("right"));
  write("lessons/hermite/de.md", lesson("right"));
  const build = spawnSync(process.execPath, ["node_modules/vite/bin/vite.js", "build"], {
    cwd: root,
    encoding: "utf8",
    env: { PATH: process.env.PATH },
  });
  const output = build.stdout + build.stderr;
  expect(build.status).not.toBe(0);
  for (const message of [
    /^lessons\/bezier\/de\.md:11: TeX: Undefined control sequence: \\nonsense.*\n {4}→ mend the formula/m,
    /^lessons\/bezier\/de\.md:11: no anchor "nowhere".*\n {4}→ /m,
    new RegExp(`^lessons/bezier/de\\.md:12: unknown demo "${demo}x"\\n {4}→ did you mean "${demo}"`, "m"),
    /^lessons\/bezier\/de\.md:15: no parameter "nonsense" of .*\n {4}→ .*there are: /m,
    /^lessons\/hermite\/en\.md:1: the lesson "hermite" has no en\.md\n {4}→ /m,
  ]) {
    expect(output).toMatch(message);
  }
}, 60_000);

describe("the dev server", () => {
  let server: ViteDevServer;
  let origin = "";
  const get = async (path: string) => {
    const answer = await fetch(origin + path);
    return { status: answer.status, html: await answer.text() };
  };
  /** The moment at which the browser is told to reload. */
  const reload = () =>
    new Promise<void>((resolve) => {
      const send = server.ws.send.bind(server.ws);
      server.ws.send = ((message: { type: string }) => {
        send(message as never);
        if (message.type === "full-reload") resolve();
      }) as typeof server.ws.send;
    });

  beforeAll(async () => {
    rmSync(join(root, "lessons/hermite"), { recursive: true, force: true });
    write("lessons/bezier/de.md", lesson("first"));
    write("lessons/bezier/en.md", lesson("first"));
    server = await createServer({
      root,
      configFile: false,
      appType: "mpa",
      base: "./",
      logLevel: "silent",
      cacheDir: join(root, ".vite"),
      plugins: [straklatte()],
      server: { port: 0, host: "127.0.0.1" },
    });
    const watching = new Promise((resolve) => server.watcher.once("ready", resolve));
    await server.listen();
    await watching;
    const address = server.httpServer!.address();
    origin = `http://127.0.0.1:${typeof address === "object" ? address!.port : 0}/`;
  }, 60_000);

  afterAll(() => server.close());

  test("serves pages, and says what it has not", async () => {
    expect((await get("de/bezier/")).html).toContain("<p>first</p>");
    expect((await get(`embed/${demo}/`)).html).toContain(`<curve-demo demo="${demo}"`);
    expect((await get("de/nowhere/")).status).toBe(404);
  }, 60_000);

  test("a saved lesson shows within 300 ms", async () => {
    const times: number[] = [];
    for (const words of ["second", "third", "fourth", "fifth"]) {
      const told = reload();
      const start = performance.now();
      write("lessons/bezier/de.md", lesson(words));
      await told;
      expect((await get("de/bezier/")).html).toContain(`<p>${words}</p>`);
      times.push(performance.now() - start);
      // Nobody saves twice at once, and the watcher takes such saves for one.
      await new Promise((resolve) => setTimeout(resolve, 200));
    }
    expect(Math.min(...times)).toBeLessThanOrEqual(300);
  }, 60_000);

  test("a lesson with a mistake shows the mistake, and comes back when it is mended", async () => {
    write("lessons/bezier/de.md", lesson("$\\nonsense$"));
    const broken = await get("de/bezier/");
    expect(broken.status).toBe(500);
    expect(broken.html).toMatch(/lessons\/bezier\/de\.md:11: TeX/);
    expect((await get("de/")).status).toBe(200);
    write("lessons/bezier/de.md", lesson("mended"));
    expect(await get("de/bezier/")).toMatchObject({ status: 200, html: expect.stringContaining("mended") });
  }, 60_000);

  test("a saved demo shows, in its page and in the lessons that hold it", async () => {
    const file = `src/demos/${demo}.ts`;
    const told = reload();
    const text = readFileSync(join(root, file), "utf8");
    write(file, text.replace(/title: \{ de: "/, 'title: { de: "Neu: '));
    await told;
    expect((await get(`embed/${demo}/`)).html).toContain("<title>Neu: ");
  }, 60_000);
});
