import { expect, test } from "vitest";
import { drawCanvas } from "../../src/render/canvas/draw-canvas.ts";
import { displayList } from "../../src/render/display-list.ts";
import { palettes } from "../../src/render/theme.ts";
import { EACH, scene, views } from "./all-kinds.ts";

type Call = readonly [string, ...unknown[]];

/** A drawing context that writes down what it is asked to do. */
function recorder() {
  const calls: Call[] = [];
  const context = new Proxy({} as Record<string, unknown>, {
    get:
      (_, name: string) =>
      (...args: unknown[]) => {
        calls.push([name, ...args]);
      },
    set: (_, name: string, value: unknown) => {
      calls.push([`${name}=`, value]);
      return true;
    },
  });
  return { calls, context: context as unknown as CanvasRenderingContext2D };
}

const plane = scene.plane!.filter((mark) => mark.kind !== "raster");
const drawing = displayList({ plane: views.plane! }, { plane }, { width: 736, height: 440, lang: "de" });

function drawn(scale = 2) {
  const { calls, context } = recorder();
  drawCanvas(context, drawing, palettes.dark, scale);
  return calls;
}

test("wipes the canvas and draws at the asked scale", () => {
  expect(drawn(1.5).slice(0, 2)).toEqual([
    ["setTransform", 1.5, 0, 0, 1.5, 0, 0],
    ["clearRect", 0, 0, 736, 440],
  ]);
});

test("every state that is saved is restored, and no two windows are cut into each other", () => {
  let depth = 0;
  for (const [name] of drawn()) {
    if (name === "save") depth++;
    if (name === "restore") depth--;
    expect(depth === 0 || depth === 1).toBe(true);
  }
  expect(depth).toBe(0);
  expect(drawn().filter(([name]) => name === "clip")).toHaveLength(1);
});

test("draws the very arcs of the marks", () => {
  const calls = drawn().map(([name]) => name);
  expect(calls.filter((name) => name === "bezierCurveTo").length).toBeGreaterThan(0);
  expect(calls.filter((name) => name === "quadraticCurveTo").length).toBeGreaterThan(0);
  const curve = drawing.primitives.find((one) => one.kind === "path" && one.steps.some(([k]) => k === "C"));
  const arc = curve?.kind === "path" ? curve.steps.find(([k]) => k === "C")! : undefined;
  expect(drawn()).toContainEqual(["bezierCurveTo", ...(arc!.slice(1) as number[][]).flat()]);
});

test("colours are those of the palette", () => {
  const used = drawn().flatMap(([name, value]) => (/^(fill|stroke)Style=$/.test(name) ? [value] : []));
  expect(used.length).toBeGreaterThan(20);
  for (const colour of used) expect(Object.values(palettes.dark)).toContain(colour);
});

test("dashes do not leak: a line without dashes clears them", () => {
  let dash: unknown = [];
  const seen = new Set<string>();
  for (const [name, value] of drawn()) {
    if (name === "setLineDash") dash = value;
    if (name === "stroke") seen.add(JSON.stringify(dash));
  }
  expect(seen).toContain("[]");
  expect(seen).toContain("[5,4]");
});

test("writes every run, its rim before any letter", () => {
  const words = drawing.primitives.flatMap((one) =>
    one.kind === "text" ? one.runs.map((run) => run.text) : [],
  );
  const calls = drawn();
  expect(calls.flatMap(([name, text]) => (name === "fillText" ? [text] : []))).toEqual(words);
});

test("surfaces can be left to another painter", () => {
  const { context, calls } = recorder();
  const space = displayList(
    { space: views.space! },
    { space: [EACH.patch] },
    { width: 400, height: 300, lang: "de" },
  );
  const painted: string[] = [];
  drawCanvas(context, space, palettes.light, 1, (surfaces) => painted.push(surfaces.kind));
  expect(painted).toEqual(["facets"]);
  expect(calls.some(([name]) => name === "fill")).toBe(false);
});
