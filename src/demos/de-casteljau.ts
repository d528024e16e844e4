import { defineDemo, parameterT, points } from "../demo/index.ts";
import { bernsteinAll, deCasteljau } from "../math/index.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { label, path, point, polyline, region } from "../scene/draw.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

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
      max: 8,
      label: { de: "Kontrollpunkte", en: "Control points" },
    }),
    t: parameterT({ initial: 0.4 }),
  },
  views: {
    plane: {
      label: { de: "Kontrollpolygon, Kurve und Konstruktion", en: "Control polygon, curve and construction" },
      x: [-0.6, 5],
      y: [-0.3, 3.1],
      height: 0.58,
      narrowHeight: 0.75,
      grid: true,
    },
  },
  values: ({ points, t }) => {
    const levels = deCasteljau(points, t);
    return { t, levels, p: levels.at(-1)![0]!, weights: bernsteinAll(points.length - 1, t) };
  },
  scene: ({ points, t }, { levels, p }) => ({
    plane: [
      region("hull", "hull", points),
      polyline("polygon", "control-polygon", points),
      ...levels
        .slice(1, -1)
        .flatMap((level, r) => [
          polyline(`level-${r + 1}`, "derived", level, { name: `level-${r + 1}` }),
          ...level.map((at, i) =>
            point(`b-${r + 1}-${i}`, "derived", at, { size: "small", hollow: true, name: `b.${r + 1}.${i}` }),
          ),
        ]),
      path("rest", "curve-rest", bezierSteps(points)),
      path("curve", "curve", bezierSteps(points, [0, t])),
      point("p", "curve", p, { name: "p" }),
      label("p-label", "curve", p, { base: "p", args: [t] }),
    ],
  }),
  readout: ({ t }, { p }) => [
    { label: { base: "t" }, value: t },
    { label: { base: "p", args: ["t"] }, value: p },
  ],
  describe: ({ points, t }, { p }) => {
    const n = points.length - 1;
    return inBoth((lang) =>
      lang === "de"
        ? `Bézierkurve vom Grad ${n}. Bei t = ${formatNumber(t, lang)} führt die Konstruktion in ${n} Stufen zum Kurvenpunkt ${formatPoint(p, lang)}.`
        : `Bézier curve of degree ${n}. At t = ${formatNumber(t, lang)} the construction leads in ${n} rounds to the curve point ${formatPoint(p, lang)}.`,
    );
  },
  states: { start: { t: 0 }, half: { t: 0.5 }, end: { t: 1 } },
});
