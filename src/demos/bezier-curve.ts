import { boolean, choice, defineDemo, number, parameterT, points } from "../demo/index.ts";
import {
  bernsteinAll,
  combine,
  convexHull,
  elevateDegree,
  hodograph,
  lagrangeBasis,
  type Point,
} from "../math/index.ts";
import { barView, weightBar } from "../scene/bars.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { disc, label, path, point, polyline, region } from "../scene/draw.ts";
import { endTangents } from "../scene/end-tangents.ts";
import { evenly } from "../scene/hermite-steps.ts";
import { interpolantSteps } from "../scene/interpolant-steps.ts";
import { symbol, wording } from "../scene/label.ts";
import type { Mark } from "../scene/marks.ts";
import { formatNumbers, formatPoints } from "../words/lists.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** A Bézier curve as the weighted mean of its control points, with what its control polygon tells. */
export default defineDemo({
  id: "bezier-curve",
  title: { de: "Bézierkurve", en: "Bézier curve" },
  params: {
    points: points({
      initial: [
        [0, 0],
        [0.9, 2.3],
        [3.3, 2.7],
        [4.4, 0.3],
      ],
      min: 2,
      max: 11,
      label: { de: "Kontrollpunkte", en: "Control points" },
    }),
    t: parameterT({ initial: 0.4 }),
    weights: boolean({ initial: true, label: { de: "Gewichte zeigen", en: "Show the weights" } }),
    hull: boolean({ initial: true, label: { de: "Konvexe Hülle", en: "Convex hull" } }),
    tangents: boolean({
      initial: false,
      label: { de: "Ableitungen an den Enden", en: "Derivatives at the ends" },
    }),
    elevate: number({
      initial: 0,
      min: 0,
      max: 12,
      step: 1,
      whole: true,
      label: { de: "Grad erhöhen um", en: "Elevate the degree by" },
    }),
    method: choice({
      initial: "bezier",
      label: { de: "Kurve", en: "Curve" },
      options: [
        { id: "bezier", label: { de: "Bézierkurve", en: "Bézier curve" } },
        {
          id: "interpolation",
          label: { de: "Polynom durch die Punkte", en: "polynomial through the points" },
        },
        { id: "both", label: { de: "beide", en: "both" } },
      ],
    }),
  },
  views: {
    plane: {
      label: { de: "Kontrollpunkte und Kurve", en: "Control points and curve" },
      x: [-0.6, 5],
      y: [-0.3, 3.1],
      height: 0.58,
      narrowHeight: 0.72,
      grid: true,
    },
    bar: barView({ label: { de: "Gewichte der Kontrollpunkte", en: "Weights of the control points" } }),
  },
  values: ({ points, t, method }) => {
    const n = points.length - 1;
    const weights = method === "interpolation" ? lagrangeBasis(evenly(0, 1, n), t) : bernsteinAll(n, t);
    const derivative = hodograph(points);
    return {
      t,
      degree: n,
      weights,
      sum: weights.reduce((sum, weight) => sum + weight, 0),
      p: combine(weights, points),
      start: derivative[0]!,
      end: derivative.at(-1)!,
      corners: convexHull(points),
    };
  },
  scene: ({ points, t, weights, hull, tangents, elevate, method }, values) => {
    const bezier = method !== "interpolation";
    const elevated = elevate > 0 ? elevateDegree(points, elevate) : [];
    const bezierMarks: Mark[] = [
      path("rest", "curve-rest", bezierSteps(points)),
      path("curve", "curve", bezierSteps(points, [0, t]), { name: "curve" }),
    ];
    return {
      plane: [
        ...(hull ? [region("hull", "hull", values.corners, { name: "hull" })] : []),
        polyline("polygon", "control-polygon", points, { name: "polygon" }),
        ...(weights
          ? values.weights.map((w, i) =>
              disc(`weight-${i}`, points[i]!, w, { index: i, name: `weights.${i}` }),
            )
          : []),
        ...(method === "bezier" ? [] : [path("interpolant", "bad", interpolantSteps(points))]),
        ...(bezier ? bezierMarks : []),
        ...(elevate > 0 ? [polyline("elevated", "derived", elevated)] : []),
        ...elevated.map((at, i) => point(`elevated-${i}`, "derived", at, { size: "small", hollow: true })),
        ...(tangents && bezier ? endTangents(points) : []),
        point("p", bezier ? "curve" : "bad", values.p, { name: "p" }),
        label("p-label", bezier ? "curve" : "bad", values.p, { base: "p", args: [t] }),
      ],
      bar: weights
        ? weightBar(values.weights, (w) => wording(inBoth((lang) => formatNumber(w, lang, 3, true))))
        : [],
    };
  },
  readout: ({ tangents, method }, { p, start, end, sum, degree }) =>
    tangents
      ? [
          { label: { base: "p", prime: 1, args: [0] }, value: start },
          { label: { base: "p", prime: 1, args: [1] }, value: end },
        ]
      : [
          { label: { base: "p", args: ["t"] }, value: p },
          { label: method === "interpolation" ? symbol("ΣL", "i") : symbol("ΣB", "i", degree), value: sum },
        ],
  describe: (
    { points, t, weights, hull, tangents, elevate, method },
    { degree, p, weights: w, start, end },
  ) =>
    inBoth((lang) => {
      const de = lang === "de";
      const at = (point: Point) => formatPoint(point, lang);
      const interpolation = de
        ? `Polynom vom Grad ${degree} durch die Punkte ${formatPoints(points, lang)}.`
        : `Polynomial of degree ${degree} through the points ${formatPoints(points, lang)}.`;
      const bezier = de
        ? `Bézierkurve vom Grad ${degree} mit den Kontrollpunkten ${formatPoints(points, lang)}.`
        : `Bézier curve of degree ${degree} with the control points ${formatPoints(points, lang)}.`;
      const place = de
        ? `Bei t = ${formatNumber(t, lang)} liegt der Kurvenpunkt bei ${at(p)}.`
        : `At t = ${formatNumber(t, lang)} the curve point is ${at(p)}.`;
      const shares = de
        ? `Die Gewichte der Punkte sind ${formatNumbers(w, lang, 3)}; ihre Summe ist 1.`
        : `The weights of the points are ${formatNumbers(w, lang, 3)}; their sum is 1.`;
      const outline = de
        ? "Die konvexe Hülle der Kontrollpunkte ist getönt."
        : "The convex hull of the control points is shaded.";
      const ends = de
        ? `Die Ableitung ist am Anfang ${at(start)}, am Ende ${at(end)}.`
        : `The derivative is ${at(start)} at the start and ${at(end)} at the end.`;
      const higher = de
        ? `Dieselbe Kurve hat auch ein Kontrollpolygon vom Grad ${degree + elevate}.`
        : `The same curve also has a control polygon of degree ${degree + elevate}.`;
      return [
        method === "interpolation" ? interpolation : bezier,
        place,
        ...(weights ? [shares] : []),
        ...(hull ? [outline] : []),
        ...(tangents && method !== "interpolation" ? [ends] : []),
        ...(elevate > 0 ? [higher] : []),
        ...(method === "both" ? [interpolation] : []),
      ].join(" ");
    }),
  states: {
    start: { t: 0 },
    half: { t: 0.5 },
    end: { t: 1 },
    line: {
      points: [
        [0.4, 0.4],
        [4, 2.4],
      ],
    },
    parabola: {
      points: [
        [0.2, 0.3],
        [2, 2.9],
        [4.3, 0.6],
      ],
    },
    stop: {
      points: [
        [0.3, 0.3],
        [0.3, 0.3],
        [3.3, 2.7],
        [3.6, 2.3],
      ],
      tangents: true,
    },
  },
});
