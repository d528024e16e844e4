import { boolean, choice, defineDemo, number, points } from "../demo/index.ts";
import {
  bezierCurve,
  distance,
  graphSurface,
  isoCurve,
  limitNormal,
  revolvedSurface,
  type Surface,
  sphereSurface,
  surfaceNormal,
} from "../math/index.ts";
import { label, path, point } from "../scene/draw.ts";
import { facetMesh } from "../scene/facet-mesh.ts";
import { evenly, hermiteSteps } from "../scene/hermite-steps.ts";
import { type Label, symbol, wording } from "../scene/label.ts";
import type { Mark } from "../scene/marks.ts";
import { normalMarks } from "../scene/normal-marks.ts";
import { spaceView } from "../scene/space.ts";
import { axisArrows, ground, patch, sampleSurface } from "../scene/surfaces.ts";
import { type DomainEnds, domainMarks, domainView } from "../scene/uv-domain.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth, type Words } from "../words/words.ts";

const plain = (base: string): Label => ({ base, style: "text" });
const REACH = 1.3;
/** z = 0.45·(x² − y²) and its derivatives. */
const saddle = (x: number, y: number, k: number, l: number): number => {
  if (k + l === 0) return 0.45 * (x * x - y * y);
  if (k > 0 && l > 0) return 0;
  const [t, r, sign] = k > 0 ? [x, k, 1] : [y, l, -1];
  return sign * 0.45 * (r === 1 ? 2 * t : r === 2 ? 2 : 0);
};

interface Example {
  readonly surface: Surface;
  readonly name: Words;
  readonly ends: DomainEnds;
}

const EXAMPLES = {
  sphere: {
    surface: sphereSurface(1.3),
    name: { de: "Kugel", en: "Sphere" },
    ends: {
      u: [plain("0"), { base: "2π" }],
      v: [{ base: "−π/2" }, { base: "π/2" }],
    },
  },
  graph: {
    surface: graphSurface(saddle, [-REACH, REACH], [-REACH, REACH]),
    name: { de: "Graph einer Funktion", en: "Graph of a function" },
    ends: {
      u: [wording({ de: "−1,3", en: "−1.3" }), wording({ de: "1,3", en: "1.3" })],
      v: [wording({ de: "−1,3", en: "−1.3" }), wording({ de: "1,3", en: "1.3" })],
    },
  },
  vase: {
    surface: revolvedSurface(bezierCurve([[0.55, -1.2], [1.9, -0.5], [0.1, 0.4], [0.95, 1.2]])), // biome-ignore format: four points
    name: { de: "Drehfläche", en: "Surface of revolution" },
    ends: { u: [plain("0"), { base: "2π" }], v: [plain("0"), plain("1")] },
  },
} as const satisfies Record<string, Example>;

type Id = keyof typeof EXAMPLES;

/** A parametric surface: a rectangle of the plane, bent into space; and the polygon mesh that stands for it. */
export default defineDemo({
  id: "parametric-surface",
  title: { de: "Parametrische Fläche", en: "Parametric surface" },
  params: {
    surface: choice({
      initial: "sphere",
      label: { de: "Fläche", en: "Surface" },
      options: [
        { id: "sphere", label: EXAMPLES.sphere.name },
        { id: "graph", label: EXAMPLES.graph.name },
        { id: "vase", label: EXAMPLES.vase.name },
      ],
    }),
    uv: points({
      initial: [[0.87, 0.68]],
      label: { de: "Ort im Parameterrechteck, in Anteilen", en: "Place in the rectangle, as shares" },
      names: [{ base: "u, v" }],
      axes: ["u", "v"],
      view: "domain",
      x: [0, 1],
      y: [0, 1],
      indexed: false,
    }),
    mesh: boolean({ initial: false, label: { de: "Als Polygonnetz", en: "As a polygon mesh" } }),
    facets: number({
      initial: 12,
      min: 3,
      max: 40,
      step: 1,
      whole: true,
      label: { de: "Facetten je Richtung", en: "Facets each way" },
    }),
    normal: boolean({ initial: false, label: { de: "Normale zeigen", en: "Show the normal" } }),
  },
  views: {
    space: spaceView({
      label: { de: "Fläche im Raum", en: "Surface in space" },
      radius: 1.85,
      yaw: 30,
      pitch: 22,
      height: 0.56,
      narrowHeight: 0.78,
    }),
    domain: domainView(),
  },
  values: ({ surface: id, uv, mesh, facets }) => {
    const { surface } = EXAMPLES[id];
    const [[u0, u1], [v0, v1]] = surface.domain;
    const [a, b] = uv[0] as readonly [number, number];
    const [u, v] = [a === 1 ? u1 : u0 + (u1 - u0) * a, b === 1 ? v1 : v0 + (v1 - v0) * b];
    const s = surface.point(u, v);
    return {
      u,
      v,
      s,
      normal: surfaceNormal(surface, u, v),
      limit: limitNormal(surface, u, v),
      /** How far the mesh is off; asked for only where it is shown. */
      gap: mesh ? meshError(surface, facets) : null,
      square: s.reduce((sum, x) => sum + x * x, 0),
    };
  },
  scene: ({ surface: id, uv, mesh, facets, normal }, { u, v, s, normal: n, limit }) => {
    const { surface, ends } = EXAMPLES[id];
    return {
      space: [
        ground(-1.4, [-1.75, 1.75], [-1.75, 1.75], 0.5),
        ...axisArrows([-1.75, -1.75, -1.4], 0.6),
        patch("surface", mesh ? facetMesh(surface, [facets, facets]) : smooth(id), { name: "S" }),
        ...(mesh ? [] : gridLines(surface)),
        line("u-line", surface, "v", v),
        line("v-line", surface, "u", u),
        ...(normal ? normalMarks(s, n, 0.7, limit) : []),
        point("s", "curve", s, { name: "s" }),
        label("s-label", "curve", s, { base: "S", args: ["u", "v"] }),
      ],
      domain: domainMarks(uv[0] as readonly [number, number], { ends }),
    };
  },
  readout: ({ surface: id, mesh }, { u, v, s, gap, square }) => [
    { label: symbol("u"), value: u },
    { label: symbol("v"), value: v },
    { label: { base: "S", args: ["u", "v"] }, value: s },
    ...(mesh
      ? [{ label: wording({ de: "Abstand des Netzes", en: "distance of the mesh" }), value: gap, digits: 3 }]
      : id === "sphere"
        ? [{ label: { base: "x² + y² + z²" }, value: square }]
        : []),
  ],
  describe: ({ surface: id, mesh, facets }, { u, v, s, gap }) =>
    inBoth((lang) => {
      const name = EXAMPLES[id].name[lang];
      const [at, to] = [`u = ${formatNumber(u, lang)}, v = ${formatNumber(v, lang)}`, formatPoint(s, lang)];
      if (lang === "de") {
        const kind = mesh
          ? `, als Polygonnetz mit ${facets} mal ${facets} Facetten; es weicht bis zu ${formatNumber(gap ?? 0, lang, 3)} ab`
          : "";
        return `${name}${kind}. Zu ${at} im Parameterrechteck gehört der Flächenpunkt ${to}.`;
      }
      const kind = mesh
        ? `, as a polygon mesh of ${facets} by ${facets} facets; it is off by up to ${formatNumber(gap ?? 0, lang, 3)}`
        : "";
      return `${name}${kind}. To ${at} in the parameter rectangle belongs the surface point ${to}.`;
    }),
  states: {
    coarse: { mesh: true, facets: 8 },
    fine: { mesh: true, facets: 40 },
    pole: { surface: "sphere", uv: [[0.87, 1]], normal: true, camera: [30, 50, 7.4] },
    graph: { surface: "graph" },
    vase: { surface: "vase" },
    seam: { surface: "sphere", uv: [[0, 0.5]], camera: [90, 20, 7.4] },
  },
});

const smoothed = new Map<Id, ReturnType<typeof sampleSurface>>();

/** The surfaces of this figure never change: each is sampled once. */
function smooth(id: Id): ReturnType<typeof sampleSurface> {
  let found = smoothed.get(id);
  if (!found) {
    found = sampleSurface(EXAMPLES[id].surface, id === "graph" ? [24, 24] : [48, 24]);
    smoothed.set(id, found);
  }
  return found;
}

function line(name: string, surface: Surface, fixed: "u" | "v", value: number): Mark {
  const curve = isoCurve(surface, fixed, value);
  const steps = hermiteSteps(curve.point, curve.derivative, evenly(...curve.domain, 12));
  return path(name, "curve", steps, { name });
}

/** The net of lines u = const, v = const that the rectangle's grid becomes. */
function gridLines(surface: Surface): Mark[] {
  return (["u", "v"] as const).flatMap((fixed, k) =>
    evenly(...surface.domain[k]!, 8).map((value, i): Mark => {
      const curve = isoCurve(surface, fixed, value);
      return path(
        `grid-${fixed}-${i}`,
        "mesh",
        hermiteSteps(curve.point, curve.derivative, evenly(...curve.domain, 12)),
      );
    }),
  );
}

/** The largest distance, at the middles of the facets, between mesh and surface. */
function meshError(surface: Surface, facets: number): number {
  const [[u0, u1], [v0, v1]] = surface.domain;
  const at = (i: number, j: number) =>
    surface.point(u0 + ((u1 - u0) * i) / facets, v0 + ((v1 - v0) * j) / facets);
  const corners = evenly(0, facets, facets).map((i) => evenly(0, facets, facets).map((j) => at(i, j)));
  let most = 0;
  for (let i = 0; i < facets; i++) {
    for (let j = 0; j < facets; j++) {
      const [a, b, c, d] = [
        corners[i]![j]!,
        corners[i + 1]![j]!,
        corners[i + 1]![j + 1]!,
        corners[i]![j + 1]!,
      ];
      const middle = a.map((x, k) => (x + b[k]! + c[k]! + d[k]!) / 4);
      most = Math.max(most, distance(middle, at(i + 0.5, j + 0.5)));
    }
  }
  return most;
}
