import { boolean, choice, defineDemo, points } from "../demo/index.ts";
import { bezierPatch, cross, limitNormal, norm, patchIsoCurve, surfaceNormal } from "../math/index.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { arrow, label, path, point, region } from "../scene/draw.ts";
import { symbol } from "../scene/label.ts";
import type { Mark } from "../scene/marks.ts";
import { normalMarks } from "../scene/normal-marks.ts";
import { patchEdges } from "../scene/patch-lines.ts";
import { spaceView } from "../scene/space.ts";
import { axisArrows, ground, patch, sampleSurface } from "../scene/surfaces.ts";
import { domainMarks, domainView } from "../scene/uv-domain.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** Derivatives are drawn at this share of their length, so that they stay in the picture. */
const SCALE = 0.3;

const NETS = {
  regular: [
    [
      [-1.6, -1.6, 0],
      [-1.6, -0.5, 0.5],
      [-1.6, 0.5, 0.6],
      [-1.6, 1.6, 0.2],
    ],
    [
      [-0.5, -1.6, 0.8],
      [-0.5, -0.5, 1.4],
      [-0.5, 0.5, 1.5],
      [-0.5, 1.6, 0.7],
    ],
    [
      [0.5, -1.6, 0.9],
      [0.5, -0.5, 1.3],
      [0.5, 0.5, 0.9],
      [0.5, 1.6, 0.5],
    ],
    [
      [1.6, -1.6, 0.1],
      [1.6, -0.5, 0.5],
      [1.6, 0.5, 0.1],
      [1.6, 1.6, -0.3],
    ],
  ],
  collapsed: [
    [
      [-1.6, 0, 0.9],
      [-1.6, 0, 0.9],
      [-1.6, 0, 0.9],
      [-1.6, 0, 0.9],
    ],
    [
      [-0.7, -1.1, 1.1],
      [-0.7, -0.4, 1.5],
      [-0.7, 0.4, 1.5],
      [-0.7, 1.1, 1.1],
    ],
    [
      [0.5, -1.6, 0.9],
      [0.5, -0.5, 1.2],
      [0.5, 0.5, 1.2],
      [0.5, 1.6, 0.9],
    ],
    [
      [1.6, -1.6, 0],
      [1.6, -0.5, 0.2],
      [1.6, 0.5, 0.2],
      [1.6, 1.6, 0],
    ],
  ],
  parallel: [
    [
      [-1.5, -1.5, 0.3],
      [-0.9, -1.1, 0.5],
      [-0.2, 0.1, 1],
      [-0.4, 1.6, 0.6],
    ],
    [
      [-0.9, -1.1, 0.5],
      [-0.3, -0.6, 0.9],
      [0.1, 0.3, 1.2],
      [0.2, 1.5, 0.8],
    ],
    [
      [0.1, -0.8, 0.9],
      [0.5, -0.5, 1],
      [0.8, 0.4, 1],
      [0.9, 1.3, 0.6],
    ],
    [
      [1.6, -1, 0.4],
      [1.6, -0.4, 0.6],
      [1.6, 0.5, 0.4],
      [1.6, 1.2, 0],
    ],
  ],
} as const;

/** The partial derivatives at a point of a surface, the tangent plane they span, and the normal, where there is one. */
export default defineDemo({
  id: "surface-tangents",
  title: { de: "Tangenten und Normale einer Fläche", en: "Tangents and normal of a surface" },
  params: {
    uv: points({
      initial: [[0.4, 0.45]],
      label: { de: "Parameter u und v", en: "Parameters u and v" },
      names: [{ base: "u, v" }],
      axes: ["u", "v"],
      view: "domain",
      x: [0, 1],
      y: [0, 1],
      indexed: false,
    }),
    shape: choice({
      initial: "regular",
      label: { de: "Fläche", en: "Surface" },
      options: [
        { id: "regular", label: { de: "überall regulär", en: "regular everywhere" } },
        { id: "collapsed", label: { de: "eine Seite ist ein Punkt", en: "one edge is a point" } },
        {
          id: "parallel",
          label: { de: "parallele Tangenten in einer Ecke", en: "parallel tangents at a corner" },
        },
      ],
    }),
    swap: boolean({ initial: false, label: { de: "u und v vertauschen", en: "Exchange u and v" } }),
    plane: boolean({ initial: true, label: { de: "Tangentialebene zeigen", en: "Show the tangent plane" } }),
  },
  views: {
    space: spaceView({
      label: { de: "Fläche mit Tangenten und Normale", en: "Surface with tangents and normal" },
      target: [0, 0, 0.5],
      radius: 1.92,
      yaw: 30,
      pitch: 28,
      height: 0.56,
      narrowHeight: 0.78,
    }),
    domain: domainView(),
  },
  values: ({ uv, shape, swap }) => {
    const [u, v] = uv[0] as readonly [number, number];
    const surface = bezierPatch(netOf(shape, swap));
    const [su, sv] = [surface.partial(u, v, 1, 0), surface.partial(u, v, 0, 1)];
    return {
      u,
      v,
      s: surface.point(u, v),
      su,
      sv,
      product: norm(cross(su, sv)),
      normal: surfaceNormal(surface, u, v),
      limit: limitNormal(surface, u, v),
    };
  },
  scene: ({ shape, swap, plane }, { u, v, s, su, sv, normal, limit }) => {
    const net = netOf(shape, swap);
    return {
      space: [
        ground(-0.9, [-1.75, 1.75], [-1.75, 1.75], 0.5),
        ...axisArrows([-1.75, -1.75, -0.9], 0.6),
        patch("surface", sampleOf(shape, swap), { name: "S" }),
        ...patchEdges(net, "curve-rest"),
        path("u-line", "curve", bezierSteps(patchIsoCurve(net, "v", v)), { name: "u-line" }),
        path("v-line", "curve", bezierSteps(patchIsoCurve(net, "u", u)), { name: "v-line" }),
        ...(plane && normal ? [tangentPlane(s, su, sv)] : []),
        ...derivative("su", s, su, 0),
        ...derivative("sv", s, sv, 2),
        ...normalMarks(s, normal, 0.85, limit),
        point("s", "curve", s, { name: "s" }),
      ],
      domain: domainMarks([u, v]),
    };
  },
  readout: (_, { su, sv, product, normal }) => [
    { label: symbol("S", "u"), value: su, index: 0 },
    { label: symbol("S", "v"), value: sv, index: 2 },
    { label: { base: "‖Sᵤ × Sᵥ‖", style: "text" }, value: product },
    { label: symbol("n"), value: normal },
  ],
  describe: (_, { u, v, s, su, sv, product, normal }) =>
    inBoth((lang) => {
      const p = (x: readonly number[]) => formatPoint(x, lang);
      const at = `u = ${formatNumber(u, lang)}, v = ${formatNumber(v, lang)}`;
      if (lang === "de") {
        const end = normal
          ? `Ihr Kreuzprodukt hat die Länge ${formatNumber(product, lang)}; die Normale ist ${p(normal)}.`
          : "Ihr Kreuzprodukt verschwindet: Hier gibt es keine Normale.";
        return `Bei ${at} liegt der Flächenpunkt ${p(s)}. Die Ableitung nach u ist ${p(su)}, die nach v ${p(sv)}. ${end}`;
      }
      const end = normal
        ? `Their cross product has the length ${formatNumber(product, lang)}; the normal is ${p(normal)}.`
        : "Their cross product vanishes: there is no normal here.";
      return `At ${at} lies the surface point ${p(s)}. The derivative in u is ${p(su)}, the one in v ${p(sv)}. ${end}`;
    }),
  states: {
    swapped: { swap: true },
    below: { camera: [30, -25, 8] },
    tip: { shape: "collapsed", uv: [[0, 0.5]] },
    near: { shape: "collapsed", uv: [[0.05, 0.5]] },
    corner: { shape: "parallel", uv: [[0, 0]] },
  },
});

type Shape = keyof typeof NETS;
type Net = readonly (readonly (readonly number[])[])[];

function netOf(shape: Shape, swap: boolean): Net {
  const net: Net = NETS[shape];
  return swap ? net[0]!.map((_, j) => net.map((row) => row[j]!)) : net;
}

const sampled = new Map<string, ReturnType<typeof sampleSurface>>();

/** The surfaces of this figure never change: each is sampled once. */
function sampleOf(shape: Shape, swap: boolean): ReturnType<typeof sampleSurface> {
  const id = `${shape} ${swap}`;
  let found = sampled.get(id);
  if (!found) {
    found = sampleSurface(bezierPatch(netOf(shape, swap)), [20, 20]);
    sampled.set(id, found);
  }
  return found;
}

function derivative(
  name: "su" | "sv",
  s: readonly number[],
  vector: readonly number[],
  index: number,
): Mark[] {
  const tip = s.map((x, k) => x + SCALE * vector[k]!);
  const text = symbol("S", name[1]!);
  return [
    arrow(name, "tangent", s, tip, { index, name }),
    label(`${name}-label`, "tangent", tip, text, { index, name, toward: vector }),
  ];
}

function tangentPlane(s: readonly number[], su: readonly number[], sv: readonly number[]): Mark {
  const at = (a: number, b: number) => s.map((x, k) => x + 0.75 * SCALE * (a * su[k]! + b * sv[k]!));
  return region("plane", "handle", [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)], { name: "plane" });
}
