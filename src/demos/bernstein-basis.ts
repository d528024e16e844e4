import { boolean, defineDemo, number, parameterT } from "../demo/index.ts";
import { bernstein, bernsteinAll } from "../math/index.ts";
import { bernsteinBand, bernsteinGraph } from "../scene/bernstein-graph.ts";
import { label, path, point, polyline, region } from "../scene/draw.ts";
import { symbol } from "../scene/label.ts";
import type { Mark, PathStep, XY } from "../scene/marks.ts";
import type { View } from "../scene/view.ts";
import { formatNumbers } from "../words/lists.ts";
import { formatNumber } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

const WINDOW: Pick<View, "x" | "y" | "fit" | "axes"> = {
  x: [0, 1],
  y: [0, 1.04],
  fit: "stretch",
  axes: { x: symbol("t") },
};

/** Up to this degree every polynomial carries its name. */
const LETTERED = 6;

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
    const graph = (k: number) => path(`graph-${k}`, shown(k) ? "curve" : "ghost", graphs(n)[k]!, name(k));
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
        ...weights.flatMap((w, k) => (shown(k) ? [point(`value-${k}`, "curve", [t, w], name(k))] : [])),
        ...weights.flatMap((_, k) => (lettered(k) ? [peakLabel(n, k)] : [])),
      ],
      stack: stack(n, t, weights, shown),
    };
  },
  readout: ({ t, degree, i }, { value, sum }) => [
    { label: symbol("t"), value: t },
    { label: { ...symbol("B", i, degree), args: ["t"] }, value, digits: 3, index: i },
    { label: { base: "Σ" }, value: sum },
  ],
  describe: ({ t, degree, i }, { weights, peak }) =>
    inBoth((lang) => {
      const [at, most, top] = [t, i / degree, peak].map((x) => formatNumber(x, lang, 3));
      const all = formatNumbers(weights, lang, 3);
      return lang === "de"
        ? `Die ${degree + 1} Bernstein-Polynome vom Grad ${degree} über dem Intervall von 0 bis 1. Bei t = ${at} haben sie die Werte ${all}; gestapelt füllen sie die Höhe 1. Das Polynom mit dem Index ${i} ist bei t = ${most} am größten, mit dem Wert ${top}.`
        : `The ${degree + 1} Bernstein polynomials of degree ${degree} over the interval from 0 to 1. At t = ${at} their values are ${all}; stacked, they fill the height 1. The polynomial with index ${i} is largest at t = ${most}, with the value ${top}.`;
    }),
  states: {
    half: { t: 0.5 },
    start: { t: 0 },
    end: { t: 1 },
    mirror: { mirror: true },
    high: { degree: 20 },
  },
});

/** The coefficients that sum the polynomials 0 … k: 1 as often, then 0. */
const upTo = (n: number, k: number) => Array.from({ length: n + 1 }, (_, j) => (j <= k ? 1 : 0));
const unit = (n: number, k: number) => Array.from({ length: n + 1 }, (_, j) => (j === k ? 1 : 0));

/** Graphs and bands do not depend on t: each degree is drawn once. */
const graphs = once((n) => unit(n, 0).map((_, k) => bernsteinGraph(unit(n, k))));
const bands = once((n) => unit(n, 0).map((_, k) => bernsteinBand(upTo(n, k - 1), upTo(n, k))));

function once(draw: (n: number) => PathStep[][]): (n: number) => PathStep[][] {
  const drawn = new Map<number, PathStep[][]>();
  return (n) => {
    const found = drawn.get(n) ?? draw(n);
    drawn.set(n, found);
    return found;
  };
}

/** The name of polynomial k at its highest point, away from the window's edges. */
function peakLabel(n: number, k: number): Mark {
  const t = inside(k / n);
  return label(`name-${k}`, "curve", [t, bernstein(n, k, t)], symbol("B", k, n), {
    index: k,
    name: `weights.${k}`,
    toward: [0, 1],
  });
}

/** Half the width of the stacked bar at t, and the room that names keep from it and from the edges. */
const HALF = 0.022;
const ROOM = 0.07;
const inside = (t: number) => Math.min(Math.max(t, ROOM), 1 - ROOM);

/** The bands between the sums B_0 + … + B_k, with a bar at t: its pieces are the weights. */
function stack(n: number, t: number, weights: readonly number[], shown: (k: number) => boolean): Mark[] {
  const [left, right] = [Math.max(0, t - HALF), Math.min(1, t + HALF)];
  let sum = 0;
  const pieces = weights.map((weight, k) => {
    const low = sum;
    sum += weight;
    const corners = [
      [left, low],
      [right, low],
      [right, sum],
      [left, sum],
    ];
    return region(`piece-${k}`, "weight", corners, { index: k, name: `weights.${k}` });
  });
  return [
    ...bands(n).map((steps, k) =>
      path(`band-${k}`, shown(k) ? "handle" : "hull", steps, { paint: "fill", index: k }),
    ),
    ...pieces,
    polyline("one", "reference", [
      [0, 1],
      [1, 1],
    ]),
    ...(n <= LETTERED ? weights.flatMap((_, k) => bandLabel(n, k, t)) : []),
  ];
}

/** The name of band k where the band is highest, beside the bar. */
function bandLabel(n: number, k: number, t: number): Mark[] {
  const top = inside(k / n);
  const at = Math.abs(top - t) < HALF + ROOM ? t + (t > 0.5 ? -1 : 1) * (HALF + ROOM) : top;
  const below = bernsteinAll(n, at)
    .slice(0, k)
    .reduce((sum, w) => sum + w, 0);
  const height = bernstein(n, k, at);
  if (height < 0.1) return [];
  return [
    label(`band-name-${k}`, "curve", [at, below + height / 2], symbol("B", k, n), {
      index: k,
      name: `weights.${k}`,
      place: "centre",
    }),
  ];
}
