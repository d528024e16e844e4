import { glyphE } from "../data/glyph-e.generated.ts";
import { type Arc, outlineArcs } from "../data/glyph-outline.ts";
import { defineDemo, number, points } from "../demo/index.ts";
import type { Surroundings } from "../demo/param.ts";
import type { PointList } from "../demo/params/points.ts";
import { deCasteljau, type Point } from "../math/index.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { label, path, point, polyline, region } from "../scene/draw.ts";
import { symbol, wording } from "../scene/label.ts";
import type { Mark, PathStep } from "../scene/marks.ts";
import { formatPoints } from "../words/lists.ts";
import { formatNumber } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** Units of the font in one unit of the picture. */
const UNIT = 100;
const { onCurve, ends } = glyphE;

const arcsOf = (outline: readonly Point[]): Arc[] => outlineArcs({ points: outline, onCurve, ends }).flat();
const COUNT = arcsOf(glyphE.points).length;

/** The arc under the pen, and where on it the pen is. */
const under = (u: number) => ({
  k: Math.min(Math.floor(u), COUNT - 1),
  t: u - Math.min(Math.floor(u), COUNT - 1),
});

/** The stored points that shape the arc under the pen. */
const shapingNow = (outline: PointList, { state }: Surroundings) =>
  arcsOf(outline)[under(Number(state.u)).k]!.from;

const stored = points({
  initial: glyphE.points.map((at) => at.map((x) => x / UNIT)),
  label: { de: "Punkte des Umrisses", en: "Points of the outline" },
  names: onCurve.map((on, i) =>
    wording({
      de: `Punkt ${i}, ${on ? "auf der Kurve" : "neben der Kurve"}`,
      en: `point ${i}, ${on ? "on the curve" : "beside the curve"}`,
    }),
  ),
  view: "letter",
  x: [-3, 9],
  y: [-3, 9],
  indexed: false,
});

/** A letter as the font holds it: short lines and quadratic Bézier curves. The pen shows one of them in large. */
export default defineDemo({
  id: "glyph",
  title: { de: "Ein Buchstabe aus Bézierkurven", en: "A letter made of Bézier curves" },
  params: {
    u: number({
      initial: 1.25,
      min: 0,
      max: COUNT,
      step: 0.05,
      animate: 24,
      primary: true,
      label: { de: "Ort auf dem Umriss", en: "Place on the outline" },
      symbol: symbol("u"),
    }),
    outline: {
      ...stored,
      // Only what shapes the arc under the pen can be moved: forty handles would hide the letter.
      handles: (id: string, value: PointList, around: Surroundings) => {
        const shaping = shapingNow(value, around);
        const all = stored.handles(id, value, around);
        return all.filter((_, i) => shaping.includes(i)).map((handle) => ({ ...handle, lettered: false }));
      },
      fields: (id: string, value: PointList, around: Surroundings) => {
        const shaping = shapingNow(value, around);
        // Two fields a point: x and y.
        return stored.fields(id, value, around).filter((_, k) => shaping.includes(Math.floor(k / 2)));
      },
    },
  },
  views: {
    letter: {
      label: { de: "Der Buchstabe mit seinen Punkten", en: "The letter with its points" },
      x: [0, 5.4],
      y: [-0.5, 5.5],
      height: 0.58,
      narrowHeight: 0.9,
    },
    arc: {
      label: { de: "Der Bogen unter dem Stift, vergrößert", en: "The arc under the pen, enlarged" },
      x: [-0.25, 1.25],
      y: [-0.25, 1.25],
      beside: 0.4,
      height: 0.58,
      narrowHeight: 0.6,
    },
  },
  values: ({ u, outline }) => {
    const { k, t } = under(u);
    const arc = arcsOf(outline)[k]!.controlPoints;
    return { arc: k + 1, t, degree: arc.length - 1, controlPoints: arc, p: deCasteljau(arc, t).at(-1)![0]! };
  },
  scene: ({ outline }, { t, controlPoints, p }) => {
    const arcs = arcsOf(outline);
    const contour = arcs.flatMap((arc, i): PathStep[] => {
      const steps = bezierSteps(arc.controlPoints);
      return i > 0 ? steps.slice(1) : steps;
    });
    return {
      letter: [
        path("ink", "curve", [...contour, ["Z"]], { paint: "fill" }),
        polyline("polygon", "control-polygon", [...outline, outline[0]!]),
        path("contour", "curve-rest", [...contour, ["Z"]]),
        path("arc", "curve", bezierSteps(controlPoints)),
        ...outline.map((at, i) =>
          onCurve[i]
            ? point(`point-${i}`, "curve", at, { size: "small" })
            : point(`point-${i}`, "derived", at, { size: "small", hollow: true }),
        ),
        point("pen", "curve", p, { name: "p" }),
      ],
      arc: enlarged(controlPoints, t),
    };
  },
  readout: (_, { arc, t, degree }) => [
    { label: wording({ de: "Bogen", en: "arc" }), value: arc, digits: 0 },
    { label: wording({ de: "Grad", en: "degree" }), value: degree, digits: 0 },
    { label: symbol("t"), value: t },
  ],
  describe: (_, { arc, t, degree, controlPoints }) =>
    inBoth((lang) => {
      const [at, list] = [formatNumber(t, lang), formatPoints(controlPoints, lang)];
      return lang === "de"
        ? `Der Umriss des Buchstabens e besteht aus ${COUNT} Bögen. Der Stift steht auf Bogen ${arc} bei t = ${at}: einer ${degree === 1 ? "Strecke" : "Bézierkurve vom Grad 2"} mit den Kontrollpunkten ${list}.`
        : `The outline of the letter e consists of ${COUNT} arcs. The pen is on arc ${arc} at t = ${at}: a ${degree === 1 ? "straight line" : "Bézier curve of degree 2"} with the control points ${list}.`;
    }),
  states: { straight: { u: 11.5 }, joint: { u: 2 }, start: { u: 0 } },
});

/** An arc and its construction, brought to the size of the window. */
function enlarged(controlPoints: readonly Point[], t: number): Mark[] {
  const low = [0, 1].map((axis) => Math.min(...controlPoints.map((at) => at[axis]!)));
  const high = [0, 1].map((axis) => Math.max(...controlPoints.map((at) => at[axis]!)));
  const size = Math.max(high[0]! - low[0]!, high[1]! - low[1]!) || 1;
  const large = controlPoints.map((at) =>
    at.map((x, axis) => 0.5 + (x - (low[axis]! + high[axis]!) / 2) / size),
  );
  const levels = deCasteljau(large, t);
  const p = levels.at(-1)![0]!;
  return [
    region("hull", "hull", large),
    polyline("polygon", "control-polygon", large),
    ...levels.slice(1, -1).map((level, r) => polyline(`level-${r}`, "derived", level)),
    path("rest", "curve-rest", bezierSteps(large)),
    path("curve", "curve", bezierSteps(large, [0, t])),
    ...levels
      .slice(1, -1)
      .flatMap((level, r) =>
        level.map((at, i) => point(`b-${r}-${i}`, "derived", at, { size: "small", hollow: true })),
      ),
    ...large.flatMap((at, i) => [
      point(`c-${i}`, "control-polygon", at, { index: i }),
      label(`c-label-${i}`, "control-polygon", at, symbol("c", i), {
        index: i,
        toward: at.map((x) => x - 0.5),
      }),
    ]),
    point("p", "curve", p),
    label("p-label", "curve", p, { base: "p", args: ["t"] }),
  ];
}
