import { boolean, choice, defineDemo, net, number } from "../demo/index.ts";
import {
  bernsteinAll,
  bezierPoint,
  patchIsoCurve,
  patchPoint,
  patchTessellator,
  splitBezier,
  toFlatNet,
} from "../math/index.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { label, path, point, polyline, region } from "../scene/draw.ts";
import { type Label, symbol } from "../scene/label.ts";
import type { Mark, PatchMark } from "../scene/marks.ts";
import { patchEdges } from "../scene/patch-lines.ts";
import { spaceView } from "../scene/space.ts";
import { axisArrows, ground, patch } from "../scene/surfaces.ts";
import { domainMarks, domainView } from "../scene/uv-domain.ts";
import { formatPoints } from "../words/lists.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** Quads along each side of the surface. */
const STEPS = 20;
const tessellate = patchTessellator(3, 3, STEPS, STEPS);

/** The tensor product as a curve of curves: points run along four rails, and their curve sweeps the surface. */
export default defineDemo({
  id: "tensor-product",
  title: { de: "Tensorprodukt: eine Kurve aus Kurven", en: "Tensor product: a curve of curves" },
  params: {
    v: number({
      initial: 0.6,
      min: 0,
      max: 1,
      step: 0.01,
      label: { de: "Parameter v", en: "Parameter v" },
      symbol: symbol("v"),
      primary: true,
      animate: 6,
      handle: { view: "domain", at: (state) => [0, state.v as number], from: (p) => p[1]! },
    }),
    u: number({
      initial: 0.4,
      min: 0,
      max: 1,
      step: 0.01,
      label: { de: "Parameter u", en: "Parameter u" },
      symbol: symbol("u"),
      handle: { view: "domain", at: (state) => [state.u as number, 0], from: (p) => p[0]! },
    }),
    points: net({
      initial: [
        [
          [-1.6, -1.5, 0.1],
          [-1.6, -0.5, 0.9],
          [-1.5, 0.6, 1],
          [-1.4, 1.5, 0.3],
        ],
        [
          [-0.6, -1.5, 1.1],
          [-0.5, -0.5, 1.9],
          [-0.5, 0.6, 1.3],
          [-0.5, 1.6, 1.2],
        ],
        [
          [0.5, -1.5, 0.2],
          [0.5, -0.5, 0.1],
          [0.6, 0.5, 1.7],
          [0.5, 1.6, 0.3],
        ],
        [
          [1.6, -1.4, 0.5],
          [1.6, -0.5, 1.1],
          [1.6, 0.5, 0.6],
          [1.6, 1.4, -0.1],
        ],
      ],
      label: { de: "Kontrollpunkte", en: "Control points" },
      range: [-4, 4],
    }),
    order: choice({
      initial: "rows",
      label: { de: "Leitkurven", en: "Rails" },
      options: [
        { id: "rows", label: { de: "in v, die Kurve in u wandert", en: "in v, the curve in u moves" } },
        { id: "columns", label: { de: "in u, die Kurve in v wandert", en: "in u, the curve in v moves" } },
      ],
    }),
    rails: boolean({ initial: true, label: { de: "Leitkurven zeigen", en: "Show the rails" } }),
    swept: boolean({
      initial: true,
      label: { de: "Überstrichene Fläche zeigen", en: "Show the swept surface" },
    }),
  },
  views: {
    space: spaceView({
      label: { de: "Leitkurven, wandernde Kurve und Fläche", en: "Rails, moving curve and surface" },
      target: [0, 0, 0.4],
      radius: 2.05,
      yaw: -32,
      pitch: 24,
      height: 0.58,
      narrowHeight: 0.8,
    }),
    domain: domainView(),
  },
  values: ({ points, u, v, order }) => {
    const [along, across] = order === "rows" ? [v, u] : [u, v];
    const moving = railsOf(points, order).map((rail) => bezierPoint(rail, along));
    return {
      u,
      v,
      moving,
      s: patchPoint(points, u, v),
      weights: bernsteinAll(3, across),
    };
  },
  scene: ({ points, u, v, order, rails, swept }, { moving, s }) => {
    const along = order === "rows" ? v : u;
    const lines = railsOf(points, order);
    return {
      space: [
        ground(-0.8, [-1.75, 1.75], [-1.75, 1.75], 0.5),
        ...axisArrows([-1.75, 1.75, -0.8], 0.6),
        ...(swept && along > 0 ? [patch("swept", sample(points, order, along), { name: "swept" })] : []),
        ...patchEdges(points, "ghost"),
        ...(rails ? lines.flatMap((rail, i) => railMarks(rail, i, along)) : []),
        polyline("moving-polygon", "derived", moving, { name: "moving-polygon" }),
        path("moving", "curve", bezierSteps(moving), { name: "moving" }),
        path(
          "other",
          "curve-rest",
          bezierSteps(patchIsoCurve(points, order === "rows" ? "u" : "v", order === "rows" ? u : v)),
        ),
        ...moving.map((at, i) => point(`q-${i}`, "derived", at, { index: i, name: `q.${i}` })),
        ...moving.map((at, i) => label(`q-${i}-label`, "derived", at, railName(order, i), { index: i })),
        point("s", "curve", s, { name: "s" }),
        label("s-label", "curve", s, { base: "S", args: ["u", "v"] }),
      ],
      domain: [
        region("domain-swept", "handle", order === "rows" ? box(1, v) : box(u, 1)),
        ...domainMarks([u, v], { handle: false }),
      ],
    };
  },
  readout: (_, { u, v, s }) => [
    { label: symbol("u"), value: u },
    { label: symbol("v"), value: v },
    { label: { base: "S", args: ["u", "v"] }, value: s },
  ],
  describe: ({ order }, { u, v, moving, s }) =>
    inBoth((lang) => {
      const [first, second] = order === "rows" ? ["v", "u"] : ["u", "v"];
      const at = formatNumber(order === "rows" ? v : u, lang);
      const list = formatPoints(moving, lang);
      const end = `S(${formatNumber(u, lang)}${lang === "de" ? "; " : ", "}${formatNumber(v, lang)}) = ${formatPoint(s, lang)}`;
      return lang === "de"
        ? `Vier Bézierkurven in ${first} sind die Leitkurven. Bei ${first} = ${at} liegen auf ihnen die Punkte ${list}; sie sind die Kontrollpunkte der wandernden Kurve in ${second}, die die Fläche überstreicht. ${end}.`
        : `Four Bézier curves in ${first} are the rails. At ${first} = ${at} the points on them are ${list}; these are the control points of the moving curve in ${second}, which sweeps the surface. ${end}.`;
    }),
  states: {
    start: { v: 0 },
    half: { v: 0.5, u: 0.5 },
    end: { v: 1 },
    other: { order: "columns" },
  },
});

type Net = readonly (readonly (readonly number[])[])[];

/** The control polygons of the rails: the rows of the net, or its columns. */
function railsOf(points: Net, order: "rows" | "columns"): Net {
  return order === "rows" ? points : points[0]!.map((_, j) => points.map((row) => row[j]!));
}

const railName = (order: "rows" | "columns", i: number): Label => ({
  base: "q",
  sub: String(i),
  args: [order === "rows" ? "v" : "u"],
});

function railMarks(rail: readonly (readonly number[])[], i: number, t: number): Mark[] {
  const extra = { index: i, name: `rail.${i}` };
  return [
    polyline(`rail-polygon-${i}`, "control-polygon", rail, { name: `rail.${i}` }),
    path(`rail-rest-${i}`, "guide", bezierSteps(rail), extra),
    path(`rail-${i}`, "tangent", bezierSteps(rail, [0, t]), extra),
  ];
}

const box = (x: number, y: number) => [[0, 0], [x, 0], [x, y], [0, y]]; // biome-ignore format: four corners

/** The part of the surface that the moving curve has swept. */
function sample(
  points: Net,
  order: "rows" | "columns",
  along: number,
): Pick<PatchMark, "rows" | "columns" | "positions" | "normals"> {
  const parts = railsOf(points, order).map((rail) => splitBezier(rail, along)[0]);
  const count = 3 * (STEPS + 1) ** 2;
  const [positions, normals] = [new Float32Array(count), new Float32Array(count)];
  tessellate(toFlatNet(railsOf(parts, order)), positions, normals);
  return { rows: STEPS + 1, columns: STEPS + 1, positions, normals };
}
