import { boolean, choice, defineDemo, number, parameterT, vector } from "../demo/index.ts";
import {
  convexHull,
  cubicDoublePoint,
  hermiteCoefficients,
  hermiteCubicBasis,
  hermitePoint,
  norm,
  scale,
  sub,
} from "../math/index.ts";
import { disc, label, path, point, polyline, region } from "../scene/draw.ts";
import {
  bezierOf,
  DRAWN,
  directionFamily,
  lengthFamily,
  segmentPath,
  summands,
  tangentArrow,
} from "../scene/hermite-marks.ts";
import { symbol } from "../scene/label.ts";
import type { Mark, XY } from "../scene/marks.ts";
import { formatNumbers, formatPoints } from "../words/lists.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth, type Words } from "../words/words.ts";

/** No component of a tangent is larger, so that the slider of its length can reach every length there is. */
const REACH = 6;
/** The slider of the length never loses the direction. */
const SHORTEST = 0.01;

const place = (index: number, name: string, initial: XY, label: Words) =>
  vector({ initial, label, symbol: symbol("p", name), anchor: () => [0, 0], index, reach: 20 });
const tangent = (index: number, name: "0" | "1", initial: XY, label: Words) =>
  vector({
    initial,
    label,
    symbol: symbol("m", name),
    anchor: (state) => state[`p${name}`] as XY,
    scale: DRAWN,
    index,
    reach: REACH,
  });

/** The cubic with given ends and given derivatives there, and what its four data do. */
export default defineDemo({
  id: "hermite-segment",
  title: { de: "Hermite-Segment", en: "Hermite segment" },
  params: {
    p0: place(0, "0", [0, 0.2], { de: "Anfangspunkt", en: "Start point" }),
    m0: tangent(1, "0", [1.5, 1.2], { de: "Ableitung am Anfang", en: "Derivative at the start" }),
    m1: tangent(2, "1", [1.5, -1.2], { de: "Ableitung am Ende", en: "Derivative at the end" }),
    p1: place(3, "1", [1.2, 0.2], { de: "Endpunkt", en: "End point" }),
    t: parameterT({ initial: 0.4 }),
    length: number({
      initial: norm([1.5, 1.2]),
      min: 0,
      max: 9,
      step: 0.1,
      label: { de: "Länge von m₀", en: "Length of m₀" },
    }),
    family: choice({
      initial: "none",
      label: { de: "Kurvenschar", en: "Family of curves" },
      options: [
        { id: "none", label: { de: "keine", en: "none" } },
        { id: "length", label: { de: "Länge von m₀", en: "length of m₀" } },
        { id: "direction", label: { de: "Richtung von m₀ und m₁", en: "direction of m₀ and m₁" } },
      ],
    }),
    sum: boolean({ initial: false, label: { de: "Summanden zeigen", en: "Show the summands" } }),
    bezier: boolean({ initial: false, label: { de: "Bézierpunkte zeigen", en: "Show the Bézier points" } }),
  },
  views: {
    plane: {
      label: { de: "Punkte, Tangenten und Kurve", en: "Points, tangents and curve" },
      x: [-0.42, 2],
      y: [-0.3, 1.12],
      height: 0.6,
      narrowHeight: 0.74,
      grid: true,
    },
  },
  settle: (next, _, changed) => {
    if (changed.includes("m0") || !changed.includes("length")) return { ...next, length: norm(next.m0) };
    // Without a direction of its own the tangent takes that of the chord.
    const along = [next.m0, sub(next.p1, next.p0), [1, 0]].find((vector) => norm(vector) > 0)!;
    const unit = scale(along, 1 / norm(along));
    const most = REACH / Math.max(...unit.map(Math.abs));
    const m0 = scale(unit, Math.min(Math.max(next.length, SHORTEST), most));
    return { ...next, m0: m0.map((x) => Math.min(REACH, Math.max(-REACH, x))), length: norm(m0) };
  },
  values: (state) => {
    const { p0, m0, m1, p1, t } = state;
    const coefficients = hermiteCoefficients(p0, m0, m1, p1);
    const { kind, parameters, point } = cubicDoublePoint(coefficients);
    const inside = (kind === "node" || kind === "cusp") && parameters.every((s) => s >= 0 && s <= 1);
    return {
      weights: hermiteCubicBasis(t),
      slopes: hermiteCubicBasis(t, 1),
      p: hermitePoint(p0, m0, m1, p1, t),
      derivative: hermitePoint(p0, m0, m1, p1, t, 1),
      geometry: [p0, m0, m1, p1],
      coefficients,
      powers: [t ** 3, t ** 2, t, 1],
      c: bezierOf(state),
      double: inside ? point : null,
      kind: inside ? kind : "none",
      parameters: inside ? parameters : [],
    };
  },
  scene: (state, { weights, p, c, double }) => {
    const { p0, m0, m1, p1, t, family, sum, bezier } = state;
    const control: Mark[] = [
      region("hull", "hull", convexHull(c), { name: "hull" }),
      polyline("polygon", "control-polygon", c, { name: "polygon" }),
      ...[1, 2].flatMap((i) => [
        point(`c-${i}`, "derived", c[i]!, { index: i, hollow: true, name: `c.${i}` }),
        label(`c-${i}-label`, "derived", c[i]!, symbol("c", i), { index: i, name: `c.${i}` }),
      ]),
    ];
    return {
      plane: [
        ...(bezier ? control : []),
        ...(family === "length" ? lengthFamily(state) : []),
        ...(family === "direction" ? directionFamily(state) : []),
        ...(sum
          ? [p0, p1].map((at, i) =>
              disc(`weight-${i}`, at, weights[3 * i]!, { index: 3 * i, name: `weights.${3 * i}` }),
            )
          : []),
        ...tangentArrow("m0", p0, m0, 1),
        ...tangentArrow("m1", p1, m1, 2),
        path("rest", "curve-rest", segmentPath(state)),
        path("curve", "curve", segmentPath(state, t), { name: "curve" }),
        ...(sum ? summands(state, weights) : []),
        ...(double ? [point("double", "derived", double, { hollow: true, name: "double" })] : []),
        point("p", "curve", p, { name: "p" }),
        label("p-label", "curve", p, { base: "p", args: [t] }),
      ],
    };
  },
  readout: ({ length, family }, { p, derivative }) => [
    { label: { base: "p", args: ["t"] }, value: p },
    family === "length"
      ? { label: { base: { de: "Länge von m₀", en: "length of m₀" }, style: "text" }, value: length }
      : { label: { base: "p", prime: 1, args: ["t"] }, value: derivative },
  ],
  describe: ({ p0, m0, m1, p1, t, family, sum, bezier }, { p, weights, c, kind, parameters }) =>
    inBoth((lang) => {
      const de = lang === "de";
      const [start, leave, arrive, end, to] = [p0, m0, m1, p1, p].map((at) => formatPoint(at, lang));
      const at = formatNumber(t, lang);
      const twice = formatNumbers(parameters, lang);
      const families = {
        none: [],
        length: [
          de
            ? "Daneben gestrichelt die Kurven, bei denen die Ableitung am Anfang die Länge 0 bis 6 hat."
            : "Dashed beside it are the curves whose derivative at the start has the length 0 to 6.",
        ],
        direction: [
          de
            ? "Daneben gestrichelt die Kurven, deren Ableitungen um 25 und 50 Grad gedreht sind."
            : "Dashed beside it are the curves whose derivatives are turned by 25 and 50 degrees.",
        ],
      };
      return [
        de
          ? `Kubisches Hermite-Segment von ${start} mit der Ableitung ${leave} nach ${end} mit der Ableitung ${arrive}; die Pfeile sind ein Drittel so lang gezeichnet. Bei t = ${at} liegt der Kurvenpunkt bei ${to}.`
          : `Cubic Hermite segment from ${start} with the derivative ${leave} to ${end} with the derivative ${arrive}; the arrows are drawn a third as long. At t = ${at} the curve point is ${to}.`,
        ...families[family],
        ...(sum
          ? [
              de
                ? `Die Gewichte von Punkten und Ableitungen sind der Reihe nach ${formatNumbers(weights, lang, 3)}.`
                : `The weights of points and derivatives are, in order, ${formatNumbers(weights, lang, 3)}.`,
            ]
          : []),
        ...(bezier
          ? [
              de
                ? `Die Bézierpunkte sind ${formatPoints(c, lang)}.`
                : `The Bézier points are ${formatPoints(c, lang)}.`,
            ]
          : []),
        ...(kind === "node"
          ? [
              de
                ? `Die Kurve hat eine Schleife: Bei t = ${twice} geht sie durch denselben Punkt.`
                : `The curve has a loop: at t = ${twice} it passes through the same point.`,
            ]
          : []),
        ...(kind === "cusp"
          ? [de ? `Die Kurve hat bei t = ${twice} eine Spitze.` : `The curve has a cusp at t = ${twice}.`]
          : []),
      ].join(" ");
    }),
  states: {
    half: { t: 0.5 },
    doubled: { m0: [3, 2.4] },
    rest: { m0: [0, 0], m1: [0, 0] },
    cusp: { p0: [0.2, 0.4], m0: [1.8, 2], m1: [1.8, -2], p1: [0.8, 0.4], t: 0.5 },
    loop: { p0: [0.2, 0.4], m0: [2.7, 2], m1: [2.7, -2], p1: [0.8, 0.4], t: 0.5 },
    script: { p0: [0, 0], m0: [1, 0], m1: [-1, 0], p1: [1, 1], t: 0.5 },
    lengths: { p0: [-0.3, -0.15], m0: [1.2, 1.6], m1: [0.9, -0.3], p1: [1.6, -0.05], family: "length" },
    directions: { p0: [0, 0.4], m0: [2.2, 0.6], m1: [2.2, -0.6], p1: [1.2, 0.4], family: "direction" },
    summands: { sum: true },
    bezier: { bezier: true },
  },
});
