import { boolean, defineDemo, number, parameterT } from "../demo/index.ts";
import { hermiteBasis } from "../math/index.ts";
import { label, path, point, polyline } from "../scene/draw.ts";
import {
  derivativeTable,
  hermiteGraphs,
  hermiteNames,
  hermiteSymbol,
  markName,
} from "../scene/hermite-graphs.ts";
import { symbol, wording } from "../scene/label.ts";
import { formatNumber } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** The highest order m, the ends of the axis, and the shortest interval. */
const MOST = 5;
const REACH = 10;
const SHORTEST = 0.1;
/** So many polynomials carry their names in the picture; the table names them all. */
const LETTERED = 6;

const end = (initial: number, index: 0 | 1) =>
  number({
    initial,
    min: -REACH,
    max: REACH,
    step: 0.1,
    label: index === 0 ? { de: "Anfang t₀", en: "Start t₀" } : { de: "Ende t₁", en: "End t₁" },
    symbol: symbol("t", index),
  });
const whole = (de: string, en: string, letter: string, initial: number, max: number) =>
  number({ initial, min: 0, max, step: 1, whole: true, label: { de, en }, symbol: symbol(letter) });
const shown = (value: number, digits = 3, fixed = false) =>
  wording(inBoth((lang) => formatNumber(value, lang, digits, fixed)));

/** The Hermite polynomials of order m over any interval, and the table of their derivatives at its ends. */
export default defineDemo({
  id: "hermite-basis",
  title: { de: "Hermite-Polynome", en: "Hermite polynomials" },
  params: {
    u: parameterT({
      initial: 0.3,
      label: { de: "Anteil u = (t − t₀)/(t₁ − t₀)", en: "Share u = (t − t₀)/(t₁ − t₀)" },
      symbol: symbol("u"),
      handle: { view: "plane", at: ({ u }) => [Number(u), 0], from: ([x]) => x! },
    }),
    m: whole("Ordnung m", "Order m", "m", 1, MOST),
    r: whole("Ableitung r im Bild", "Derivative r in the picture", "r", 0, MOST),
    t0: end(0, 0),
    t1: end(1, 1),
    single: boolean({ initial: false, label: { de: "Nur ein Polynom", en: "One polynomial only" } }),
    i: whole("Ende i", "End i", "i", 0, 1),
    k: whole("Ableitung k", "Derivative k", "k", 1, MOST),
  },
  views: {
    plane: {
      label: { de: "Graphen der Polynome", en: "Graphs of the polynomials" },
      x: [-0.06, 1.06],
      y: [-0.68, 1.08],
      fit: "stretch",
      height: 0.52,
      narrowHeight: 0.8,
    },
    table: {
      label: { de: "Ableitungen an den Enden", en: "Derivatives at the ends" },
      x: [0, 1],
      y: [0, 1],
      fit: "stretch",
      beside: 0.44,
      height: 0.52,
      narrowHeight: 0.86,
    },
  },
  settle: (next, _, changed) => {
    const [r, k] = [Math.min(next.r, next.m), Math.min(next.k, next.m)];
    let { t0, t1 } = next;
    // The end that was not moved gives way; at the limits of the axis the other one does.
    const narrow = () => t1 - t0 < SHORTEST - 1e-9;
    if (narrow() && changed.includes("t1")) t0 = Math.max(-REACH, t1 - SHORTEST);
    if (narrow()) t1 = Math.min(REACH, t0 + SHORTEST);
    if (narrow()) t0 = t1 - SHORTEST;
    return { ...next, r, k, t0, t1 };
  },
  values: ({ m, t0, t1, u, r }) => {
    const t = t0 + u * (t1 - t0);
    const orders = Array.from({ length: m + 1 }, (_, k) => k);
    // table[i][k] = [derivatives of H_{i,k} at t₀, at t₁].
    const derivatives = [t0, t1].map((at) => orders.map((order) => hermiteBasis(m, t0, t1, at, order)));
    const table = [0, 1].map((i) =>
      orders.map((k) => derivatives.map((at) => orders.map((order) => at[order]![i]![k]!))),
    );
    const orderwise = orders.map((order) => hermiteBasis(m, t0, t1, t, order));
    return { t, h: t1 - t0, degree: 2 * m + 1, table, basis: orderwise[r]!, orderwise };
  },
  scene: ({ m, t0, t1, u, r, single, i, k }, { basis, table }) => {
    const names = hermiteNames(m);
    const { steps, peaks, top } = hermiteGraphs(m, t0, t1, r);
    const seen = (n: number) => !single || (names[n]!.i === i && names[n]!.k === k);
    const extra = (n: number) => ({ index: names[n]!.index, name: markName(names[n]!) });
    const value = (n: number) => basis[names[n]!.i]![names[n]!.k]!;
    return {
      plane: [
        polyline("axis", "axis", [
          [0, 0],
          [1, 0],
        ]),
        polyline("one", "reference", [
          [0, 1 / top],
          [1, 1 / top],
        ]),
        label("one-label", "note", [0, 1 / top], shown(1), { toward: [-1, 0] }),
        ...[t0, t1].flatMap((at, n) => [
          polyline(`end-${n}`, "guide", [
            [n, -0.6],
            [n, 1],
          ]),
          label(
            `end-${n}-label`,
            "note",
            [n, -0.64],
            wording(inBoth((lang) => `${n === 0 ? "t₀" : "t₁"} = ${formatNumber(at, lang)}`)),
            { place: "centre" },
          ),
        ]),
        polyline("at-t", "guide", [
          [u, -0.6],
          [u, 1],
        ]),
        ...names.map((_, n) => path(`graph-${n}`, seen(n) ? "curve" : "ghost", steps[n]!, extra(n))),
        ...names.flatMap((_, n) =>
          seen(n) ? [point(`value-${n}`, "curve", [u, value(n) / top], extra(n))] : [],
        ),
        ...names.flatMap((name, n) =>
          seen(n) && (single || names.length <= LETTERED)
            ? [
                label(`name-${n}`, "curve", peaks[n]!, hermiteSymbol(name, r), {
                  ...extra(n),
                  toward: [0, Math.sign(peaks[n]![1]!)],
                }),
              ]
            : [],
        ),
      ],
      table: derivativeTable(
        names,
        names.map((name) => {
          const [atStart, atEnd] = table[name.i]![name.k]!.map((row) =>
            row.map((entry) => ({ label: shown(entry), lit: Math.abs(entry - 1) < 1e-6 })),
          );
          return [atStart!, atEnd!];
        }),
        {
          head: symbol("t"),
          cells: names.map((_, n) => shown(value(n), Math.abs(value(n)) < 10 ? 3 : 0, true)),
        },
        seen,
      ),
    };
  },
  readout: ({ m, r, i, k }, { t, basis, degree }) => [
    { label: symbol("t"), value: t },
    { label: { base: { de: "Grad", en: "degree" }, style: "text" }, value: degree, digits: 0 },
    {
      label: hermiteSymbol(hermiteNames(m).find((name) => name.i === i && name.k === k)!, r),
      value: basis[i]![k]!,
      digits: 3,
    },
  ],
  describe: ({ m, t0, t1, r, i, k }, { t, basis }) =>
    inBoth((lang) => {
      const [from, to, at, value] = [t0, t1, t, basis[i]![k]!].map((x) => formatNumber(x, lang, 3));
      const count = 2 * m + 2;
      return lang === "de"
        ? `Die ${count} Hermite-Polynome vom Grad ${count - 1} über dem Intervall von ${from} bis ${to}${r > 0 ? `, gezeigt ist ihre Ableitung der Ordnung ${r}` : ""}. Die Tabelle der Ableitungen von 0 bis ${m} an beiden Enden hat in jeder Zeile eine Eins und sonst Nullen. Das Polynom mit i = ${i} und k = ${k} hat bei t = ${at} ${r > 0 ? "die Ableitung" : "den Wert"} ${value}.`
        : `The ${count} Hermite polynomials of degree ${count - 1} over the interval from ${from} to ${to}${r > 0 ? `; shown is their derivative of order ${r}` : ""}. The table of the derivatives from 0 to ${m} at both ends has a single one in each row and zeros elsewhere. The polynomial with i = ${i} and k = ${k} has the ${r > 0 ? "derivative" : "value"} ${value} at t = ${at}.`;
    }),
  states: {
    start: { u: 0 },
    end: { u: 1 },
    slopes: { r: 1 },
    linear: { m: 0 },
    quintic: { m: 2 },
    highest: { m: 5, r: 0 },
    longer: { t0: 1, t1: 3 },
    tangent: { single: true, i: 0, k: 1 },
  },
});
