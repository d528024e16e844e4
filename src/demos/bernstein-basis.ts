import { boolean, defineDemo, number, parameterT } from "../demo/index.ts";
import { bernstein, bernsteinAll } from "../math/index.ts";
import { bernsteinGraphs, bernsteinStack, LETTERED, peakLabel } from "../scene/bernstein-stack.ts";
import { path, point, polyline } from "../scene/draw.ts";
import { symbol } from "../scene/label.ts";
import type { Mark, XY } from "../scene/marks.ts";
import type { View } from "../scene/view.ts";
import { formatNumbers } from "../words/lists.ts";
import { formatNumber } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

const WINDOW: Pick<View, "x" | "y" | "fit" | "axes"> = {
  x: [0, 1],
  y: [0, 1.04],
  fit: "stretch",
  axes: { x: symbol("t"), y: symbol("") },
};

/** Values below this would only crowd the axis. */
const SEEN = 0.012;

/** All Bernstein polynomials of a degree: as graphs, and stacked, where they fill the height 1 at every t. */
export default defineDemo({
  id: "bernstein-basis",
  title: { de: "Bernstein-Polynome", en: "Bernstein polynomials" },
  params: {
    t: parameterT({
      initial: 0.4,
      handle: { view: "plane", at: ({ t }) => [Number(t), 0], from: ([x]) => x! },
    }),
    degree: number({
      initial: 3,
      min: 1,
      max: 20,
      step: 1,
      whole: true,
      label: { de: "Grad n", en: "Degree n" },
      symbol: symbol("n"),
    }),
    i: number({
      initial: 1,
      min: 0,
      max: 20,
      step: 1,
      whole: true,
      label: { de: "Index i", en: "Index i" },
      symbol: symbol("i"),
    }),
    single: boolean({ initial: false, label: { de: "Nur ein Polynom", en: "One polynomial only" } }),
    mirror: boolean({ initial: false, label: { de: "Spiegelbild bei 1 − t", en: "Mirror image at 1 − t" } }),
  },
  views: {
    plane: {
      ...WINDOW,
      label: { de: "Graphen der Polynome", en: "Graphs of the polynomials" },
      height: 0.5,
      narrowHeight: 0.7,
      grid: true,
    },
    stack: {
      ...WINDOW,
      label: { de: "Gestapelt", en: "Stacked" },
      beside: 0.42,
      height: 0.5,
      narrowHeight: 0.5,
    },
  },
  settle: (next) => (next.i > next.degree ? { ...next, i: next.degree } : next),
  values: ({ t, degree, i }) => {
    const weights = bernsteinAll(degree, t);
    return {
      t,
      degree,
      weights,
      value: weights[i]!,
      sum: weights.reduce((sum, weight) => sum + weight, 0),
      peak: bernstein(degree, i, i / degree),
    };
  },
  scene: ({ t, degree: n, i, single, mirror }, { weights }) => {
    const focus = single || mirror;
    const shown = (k: number) => !focus || k === i || (mirror && k === n - i);
    const name = (k: number) => ({ index: k, name: `weights.${k}` });
    const graph = (k: number) =>
      path(`graph-${k}`, shown(k) ? "curve" : "ghost", bernsteinGraphs(n)[k]!, name(k));
    const lettered = (k: number) => shown(k) && (n <= LETTERED || focus);
    const mirrored: XY = [1 - t, weights[i]!];
    const mirrorMarks: Mark[] = [
      polyline("mirror", "guide", [
        [1 - t, 0],
        [1 - t, 1],
      ]),
      polyline("level", "reference", [[t, weights[i]!], mirrored]),
      point("mirrored", "curve", mirrored, name(n - i)),
    ];
    return {
      plane: [
        polyline("at-t", "guide", [
          [t, 0],
          [t, 1],
        ]),
        ...weights.map((_, k) => graph(k)),
        ...(mirror ? mirrorMarks : []),
        ...weights.flatMap((w, k) =>
          shown(k) && w >= SEEN ? [point(`value-${k}`, "curve", [t, w], name(k))] : [],
        ),
        ...weights.flatMap((_, k) => (lettered(k) ? [peakLabel(n, k)] : [])),
      ],
      stack: bernsteinStack(n, t, weights, shown),
    };
  },
  readout: ({ degree, i }, { value, sum }) => [
    { label: { ...symbol("B", i, degree), args: ["t"] }, value, digits: 3, index: i },
    { label: { base: "Σ" }, value: sum },
  ],
  describe: ({ t, degree, i }, { weights, peak }) =>
    inBoth((lang) => {
      const [at, most, top] = [t, i / degree, peak].map((x) => formatNumber(x, lang, 3));
      const all = formatNumbers(weights, lang, 3);
      const [low, high] = [Math.min(...weights), Math.max(...weights)].map((x) => formatNumber(x, lang, 3));
      return lang === "de"
        ? `Die ${degree + 1} Bernstein-Polynome vom Grad ${degree} über dem Intervall von 0 bis 1. Bei t = ${at} haben sie ${degree <= LETTERED ? `die Werte ${all}` : `Werte von ${low} bis ${high}`}; gestapelt füllen sie die Höhe 1. Das Polynom mit dem Index ${i} ist bei t = ${most} am größten, mit dem Wert ${top}.`
        : `The ${degree + 1} Bernstein polynomials of degree ${degree} over the interval from 0 to 1. At t = ${at} their values ${degree <= LETTERED ? `are ${all}` : `go from ${low} to ${high}`}; stacked, they fill the height 1. The polynomial with index ${i} is largest at t = ${most}, with the value ${top}.`;
    }),
  states: {
    half: { t: 0.5 },
    start: { t: 0 },
    end: { t: 1 },
    mirror: { mirror: true },
    high: { degree: 20 },
  },
});
