import { expect, test } from "vitest";
import { figureOf } from "../../src/demo/figure.ts";
import { initialState } from "../../src/demo/state.ts";
import bezierPatch from "../../src/demos/bezier-patch.ts";
import { displayList } from "../../src/render/display-list.ts";
import { facetRgb, readColour } from "../../src/render/facet-colour.ts";
import type { FacetsPrimitive } from "../../src/render/primitives.ts";
import { writeSvg } from "../../src/render/svg-text.ts";
import { svgTree } from "../../src/render/svg-tree.ts";
import { palettes } from "../../src/render/theme.ts";
import { point } from "../../src/scene/draw.ts";
import { ground } from "../../src/scene/surfaces.ts";

const figure = figureOf(bezierPatch, initialState(bezierPatch));
const size = { width: 736, height: 442, lang: "en" } as const;
const drawing = displayList(figure.views, figure.scene, size);
const surfaces = drawing.primitives.find((one) => one.kind === "facets") as FacetsPrimitive;

test("a surface becomes facets in the window's pixels, below lines, points and letters", () => {
  const { box } = drawing.views.space!;
  expect(surfaces.facets.length).toBeGreaterThan(200);
  for (const [x, y] of surfaces.facets.flatMap(({ corners }) => corners)) {
    expect(x!).toBeGreaterThan(box.left);
    expect(x!).toBeLessThan(box.left + box.width);
    expect(y!).toBeGreaterThan(box.top);
    expect(y!).toBeLessThan(box.top + box.height);
  }
  const kinds = drawing.primitives.map((one) => one.kind);
  expect(kinds.indexOf("facets")).toBeLessThan(kinds.indexOf("circle"));
});

test("handles stand where the window puts their points of space", () => {
  const view = drawing.views.space!;
  const rings = drawing.primitives.filter((one) => one.kind === "circle" && one.part === "ring");
  for (const handle of figure.handles.filter((one) => one.view === "space")) {
    const [x, y] = view.toPixel(handle.at);
    expect(rings.some((ring) => ring.kind === "circle" && ring.at[0] === x && ring.at[1] === y)).toBe(true);
  }
});

test("in a page, tones are classes, so that the theme mixes the colours; a file has them written out", () => {
  const page = writeSvg(svgTree(drawing, { title: "t" }));
  // Not toMatch: what it prints on failure is the whole picture.
  expect(/<g class="facets"[^>]*><path class="t-(front|back) k\d+"/.test(page)).toBe(true);
  expect(page.includes('fill="#')).toBe(false);
  const file = writeSvg(svgTree(drawing, { title: "t", colours: palettes.dark }));
  expect(/<g class="facets"[^>]*><path fill="#[0-9a-f]{6}" stroke="#[0-9a-f]{6}"/.test(file)).toBe(true);
  expect(/NaN|undefined/.test(file)).toBe(false);
});

test("where a renderer draws the surfaces, it gets them and no facets are made", () => {
  const { primitives } = displayList(figure.views, figure.scene, { ...size, facets: 0 });
  const [left] = primitives.filter((one) => one.kind === "facets") as FacetsPrimitive[];
  expect(left!.facets).toEqual([]);
  expect(left!.patches.map((patch) => patch.key)).toEqual(["surface"]);
});

test("marks of space need a window into space", () => {
  const views = { plane: { label: { de: "Ebene", en: "plane" }, x: [0, 1], y: [0, 1], height: 1 } } as const;
  const scene = { plane: [point("p", "curve", [0, 0]), ground(0, [0, 1], [0, 1])] };
  expect(() => displayList(views, scene, size)).toThrow(/ground needs a view into space/);
});

test("facets are mixed from the two tones of their side, or lie on a map", () => {
  const { light } = palettes;
  const mixed = (share: number) => facetRgb({ between: "front", share }, light);
  expect(mixed(0)).toEqual(readColour(light["front-dim"]));
  expect(mixed(1)).toEqual(readColour(light["front-lit"]));
  expect(facetRgb({ map: "diverging", share: null }, light)).toEqual(readColour(light["front-dim"]));
  expect(facetRgb({ rgb: [1, 2, 3] }, light)).toEqual([1, 2, 3]);
});

test("colours are read as palettes and browsers write them", () => {
  expect(readColour("#0a5EA8")).toEqual([10, 94, 168]);
  expect(readColour("rgb(1, 2, 3)")).toEqual([1, 2, 3]);
  expect(() => readColour("Canvas")).toThrow(/Canvas/);
});
