import { boolean, defineDemo, number, parameterT, points } from "../demo/index.ts";
import { bernsteinAll, convexHull, deCasteljau, type Point, splitBezier } from "../math/index.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { label, path, point, polyline, region } from "../scene/draw.ts";
import type { Mark } from "../scene/marks.ts";
import { formatPoints } from "../words/lists.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** The most points, and so the most rounds, a figure has. */
const MOST = 8;

/** De Casteljau's construction: divide every leg in the ratio t : 1 − t, until one point is left. */
export default defineDemo({
  id: "de-casteljau",
  title: { de: "Die Konstruktion von de Casteljau", en: "De Casteljau’s construction" },
  params: {
    points: points({
      initial: [
        [0, 0],
        [0.9, 2.3],
        [3.3, 2.7],
        [4.4, 0.3],
      ],
      min: 2,
      max: MOST,
      label: { de: "Kontrollpunkte", en: "Control points" },
    }),
    t: parameterT({ initial: 0.4 }),
    rounds: number({
      initial: MOST - 1,
      min: 0,
      max: MOST - 1,
      step: 1,
      whole: true,
      label: { de: "Runden zeigen", en: "Rounds shown" },
    }),
    split: boolean({ initial: false, label: { de: "Kurve bei t teilen", en: "Split the curve at t" } }),
  },
  views: {
    plane: {
      label: { de: "Kontrollpolygon, Kurve und Konstruktion", en: "Control polygon, curve and construction" },
      x: [-0.6, 5],
      y: [-0.3, 3.1],
      height: 0.58,
      narrowHeight: 0.72,
      grid: true,
    },
  },
  values: ({ points, t }) => {
    const levels = deCasteljau(points, t);
    const [left, right] = splitBezier(points, t);
    return { t, levels, p: levels.at(-1)![0]!, weights: bernsteinAll(points.length - 1, t), left, right };
  },
  scene: ({ points, t, rounds, split }, { levels, p, left, right }) => {
    const last = levels.length - 1;
    const done = rounds >= last;
    const whole: Mark[] = [
      region("hull", "hull", convexHull(points)),
      polyline("polygon", "control-polygon", points, { name: "polygon" }),
    ];
    const parts: Mark[] = [
      region("left-hull", "handle", convexHull(left)),
      region("right-hull", "hull", convexHull(right)),
      polyline("polygon", "ghost", points, { name: "polygon" }),
    ];
    return {
      plane: [
        ...(split ? parts : whole),
        path("rest", "curve-rest", bezierSteps(points)),
        ...(done ? [path("curve", "curve", bezierSteps(points, [0, t]), { name: "curve" })] : []),
        ...levels.slice(1, split ? 1 : Math.min(last, rounds + 1)).flatMap(level),
        ...(split ? [...part("left", left), ...part("right", right)] : []),
        ...(done ? [point("p", "curve", p, { name: "p" })] : []),
        ...(done ? [label("p-label", "curve", p, { base: "p", args: [t] })] : []),
      ],
    };
  },
  readout: (_, { p }) => [{ label: { base: "p", args: ["t"] }, value: p }],
  describe: ({ points, t, rounds, split }, { p, left, right }) => {
    const n = points.length - 1;
    return inBoth((lang) => {
      const [at, to] = [formatNumber(t, lang), formatPoint(p, lang)];
      const [a, b] = [left, right].map((part) => formatPoints(part, lang));
      const de = lang === "de";
      const curve = de ? `Bézierkurve vom Grad ${n}.` : `Bézier curve of degree ${n}.`;
      if (split)
        return de
          ? `${curve} Bei t = ${at} zerfällt sie in zwei Bézierkurven; die linke hat die Kontrollpunkte ${a}, die rechte ${b}.`
          : `${curve} At t = ${at} it falls into two Bézier curves; the left one has the control points ${a}, the right one ${b}.`;
      if (rounds < n)
        return de
          ? `${curve} Die Konstruktion bei t = ${at} ist bis zur Runde ${rounds} von ${n} gezeigt.`
          : `${curve} The construction at t = ${at} is shown up to round ${rounds} of ${n}.`;
      return de
        ? `${curve} Bei t = ${at} führt die Konstruktion in ${n} Runden zum Kurvenpunkt ${to}.`
        : `${curve} At t = ${at} the construction leads in ${n} rounds to the curve point ${to}.`;
    });
  },
  states: { start: { t: 0 }, half: { t: 0.5 }, end: { t: 1 }, first: { rounds: 1 }, split: { split: true } },
});

/** One round of the construction: its legs and its points. */
function level(points: readonly Point[], r: number): Mark[] {
  const name = `b.${r + 1}`;
  return [
    polyline(name, "derived", points, { name }),
    ...points.map((at, i) =>
      point(`${name}.${i}`, "derived", at, { size: "small", hollow: true, name: `${name}.${i}` }),
    ),
  ];
}

/** The control polygon of one part of the curve: full points on the left, hollow ones on the right. */
function part(name: "left" | "right", points: readonly Point[]): Mark[] {
  const [role, hollow] =
    name === "left" ? (["tangent", false] as const) : (["control-polygon", true] as const);
  return [
    polyline(name, role, points, { name }),
    ...points.map((at, i) =>
      point(`${name}.${i}`, role, at, { size: "small", hollow, name: `${name}.${i}` }),
    ),
  ];
}
