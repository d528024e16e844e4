import { arrow, disc, label, path, point, polyline, region } from "../../src/scene/draw.ts";
import { symbol, wording } from "../../src/scene/label.ts";
import type { Views } from "../../src/scene/layout.ts";
import type { Mark, PatchMark, Scene } from "../../src/scene/marks.ts";
import { spaceView } from "../../src/scene/space.ts";

const words = { de: "Fenster", en: "Window" };

/** A flat surface of two by two samples. */
const patch: PatchMark = {
  kind: "patch",
  key: "patch",
  role: "surface",
  rows: 2,
  columns: 2,
  positions: [0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
};

/** One mark of every kind. The type asks for a new kind as soon as there is one; `facets` come of `patch`. */
export const EACH: { readonly [K in Exclude<Mark["kind"], "facets">]: Extract<Mark, { kind: K }> } = {
  path: path(
    "path",
    "curve",
    [["M", [0, 0]], ["C", [1, 2], [3, 2], [4, 0]], ["Q", [4.5, -1], [4, -0.5]], ["L", [3, -0.5]], ["Z"]],
    { paint: "both", name: "path" },
  ),
  point: point("point", "handle", [1, 1], { index: 1, name: "point" }),
  disc: disc("disc", [2, 1], -0.25, { index: 2 }),
  arrow: arrow("arrow", "tangent", [0, 0], [1, 0.5], { name: "arrow" }),
  label: label("label", "handle", [1, 1], symbol("c", 1), { index: 1, toward: [-1, 1] }),
  raster: {
    kind: "raster",
    key: "raster",
    role: "note",
    x: [3, 4],
    y: [1, 2],
    columns: 3,
    rows: 2,
    values: [0, 1, 2, 3, 4, Number.NaN],
    range: [0, 4],
    colours: "sequential",
  },
  patch,
  ground: { kind: "ground", key: "ground", role: "grid", z: 0, x: [0, 1], y: [0, 1], step: 0.5 },
};

/** A scene with every kind of mark, in a window with grid and axes and in one into space. */
export const views: Views = {
  plane: {
    label: words,
    x: [-0.5, 4.5],
    y: [-1, 2.5],
    height: 0.6,
    grid: true,
    axes: { x: symbol("x"), y: symbol("y") },
  },
  space: spaceView({ label: words, radius: 2, height: 0.4 }),
};

export const scene: Scene = {
  plane: [
    EACH.raster,
    region("region", "hull", [
      [0, 0],
      [2, 2],
      [4, 0],
    ]),
    EACH.path,
    polyline("ghost", "ghost", [
      [0, 1],
      [6, 1],
    ]),
    EACH.disc,
    EACH.arrow,
    point("small", "derived", [0.5, 1.5], { size: "small", hollow: true }),
    point("full", "curve", [2, 1.5]),
    EACH.point,
    EACH.label,
    label("p", "curve", [2, 1.5], { base: "p", prime: 1, args: [0.25] }),
    label(
      "words",
      "note",
      [3.5, 0.2],
      wording({ de: "größer < „Lot“ & mehr", en: "larger < “plumb” & more" }),
      {
        place: "centre",
      },
    ),
  ],
  space: [EACH.ground, EACH.patch],
};
