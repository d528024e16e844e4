import { hermiteBasisCurve } from "../math/index.ts";
import { label, polyline, region } from "./draw.ts";
import { evenly, hermiteSteps } from "./hermite-steps.ts";
import { type Label, symbol, wording } from "./label.ts";
import type { Mark, PathStep, XY } from "./marks.ts";

/** Which data a Hermite polynomial belongs to, and its entry of the palette: for m = 1 that of H_0 … H_3. */
export interface HermiteName {
  readonly i: 0 | 1;
  readonly k: number;
  readonly index: number;
}

/** The last entry of the palette: of twelve polynomials only the flattest ones share theirs. */
const LAST = 9;

/** The polynomials of order m as `src/math` counts them, H_{0,0} … H_{0,m}, H_{1,0} … H_{1,m}. */
export function hermiteNames(m: number): HermiteName[] {
  const orders = Array.from({ length: m + 1 }, (_, k) => k);
  return [
    ...orders.map((k) => ({ i: 0 as const, k, index: k })),
    ...orders.map((k) => ({ i: 1 as const, k, index: Math.min(2 * m + 1, LAST) - k })),
  ];
}

/** H_{i,k}, and its r-th derivative as H_{i,k}′ or H_{i,k}^{(r)}. */
export function hermiteSymbol({ i, k }: HermiteName, r = 0): Label {
  const plain = symbol("H", `${i},${k}`);
  if (r === 0) return plain;
  return r <= 3 ? { ...plain, prime: r as 1 | 2 | 3 } : symbol("H", `${i},${k}`, `(${r})`);
}

/** The name by which formulas tie to a polynomial. */
export const markName = ({ i, k }: HermiteName) => `basis.${i}.${k}`;

/** The window's part below the axis, as a share of the part above. */
const BELOW = 0.6;
/** Pieces of each graph: enough for degree 11 and its derivatives. */
const PIECES = 24;

export interface Graphs {
  readonly steps: readonly (readonly PathStep[])[];
  /** Where the name of each graph stands: at its largest modulus inside. */
  readonly peaks: readonly XY[];
  /** The value that is drawn at height 1. */
  readonly top: number;
}

/**
 * The graphs of the r-th derivatives over u from 0 to 1, t = t₀ + u·(t₁ − t₀). All are drawn to one scale, so that the
 * largest reach 1 or the lowest −0.6; a window of [0, 1] × [−0.6, 1] holds them all.
 */
export function hermiteGraphs(m: number, t0: number, t1: number, r: number): Graphs {
  const curve = hermiteBasisCurve(m, t0, t1);
  const h = t1 - t0;
  const stops = evenly(0, 1, PIECES);
  const samples = stops.map((u) => curve.derivative(t0 + u * h, r));
  const all = samples.flat();
  const top = Math.max(1, ...all, ...all.map((y) => -y / BELOW));
  const count = 2 * m + 2;
  const graphs = Array.from({ length: count }, (_, n) => n);
  const slopes = stops.map((u) => curve.derivative(t0 + u * h, r + 1));
  // Looked up by the stop itself, so that each derivative is computed once for all graphs.
  const at = new Map(stops.map((u, k) => [u, k]));
  return {
    steps: graphs.map((n) =>
      hermiteSteps(
        (u) => [u, samples[at.get(u)!]![n]! / top],
        (u) => [1, (slopes[at.get(u)!]![n]! * h) / top],
        stops,
      ),
    ),
    peaks: graphs.map((n) => {
      const inner = stops.map((_, k) => k).slice(2, -2);
      const best = inner.reduce((a, b) => (Math.abs(samples[b]![n]!) > Math.abs(samples[a]![n]!) ? b : a));
      return [stops[best]!, samples[best]![n]! / top];
    }),
    top,
  };
}

/** A cell of the table: a number in words of both languages, or the symbol of a row or column. */
export interface Cell {
  readonly label: Label;
  /** A one: the cell is tinted in the colour of its row. */
  readonly lit?: boolean;
}

/**
 * The table of derivatives: a row for each polynomial, under `t₀` and under `t₁` a column for each order 0 … m, and the
 * values at t in the last one. Draws into a window of [0, 1] × [0, 1].
 */
export function derivativeTable(
  names: readonly HermiteName[],
  ends: readonly (readonly [Cell[], Cell[]])[],
  last: { readonly head: Label; readonly cells: readonly Label[] },
  shown: (row: number) => boolean,
): Mark[] {
  const orders = names.length / 2;
  const widths = [1.9, ...new Array<number>(orders).fill(1), 0.4, ...new Array<number>(orders).fill(1), 3];
  const whole = widths.reduce((a, b) => a + b, 0);
  const left = widths.map((_, k) => widths.slice(0, k).reduce((a, b) => a + b, 0) / whole);
  const middle = (k: number) => left[k]! + widths[k]! / whole / 2;
  const height = 1 / (names.length + 2);
  const y = (row: number) => 1 - (row + 2.5) * height;
  const column = (end: number, r: number) => 1 + end * (orders + 1) + r;
  const text = (key: string, x: number, at: number, what: Label, extra = {}) =>
    label(key, "note", [x, at], what, { place: "centre", ...extra });
  const heads = [0, 1].flatMap((end) => [
    text(
      `end-${end}`,
      (left[column(end, 0)]! + left[column(end, orders - 1) + 1]!) / 2,
      y(-2),
      symbol("t", end),
    ),
    ...names
      .slice(0, orders)
      .map(({ k }) =>
        text(`order-${end}-${k}`, middle(column(end, k)), y(-1), wording({ de: `${k}`, en: `${k}` })),
      ),
  ]);
  const rows = names.flatMap((one, row): Mark[] => {
    const role = shown(row) ? "curve" : "note";
    const extra = shown(row) ? { index: one.index, name: markName(one) } : {};
    const lit = (cell: Cell) => cell.lit && shown(row);
    const cells = ends[row]!.flatMap((cells, end) =>
      cells.flatMap((cell, r): Mark[] => {
        const k = column(end, r);
        const [x0, x1] = [left[k]!, left[k]! + widths[k]! / whole];
        const [low, high] = [y(row) - height / 2, y(row) + height / 2];
        const box = [
          [x0, low],
          [x1, low],
          [x1, high],
          [x0, high],
        ];
        return [
          ...(lit(cell) ? [region(`box-${row}-${end}-${r}`, "weight", box, extra)] : []),
          label(`cell-${row}-${end}-${r}`, lit(cell) ? "weight" : "note", [middle(k), y(row)], cell.label, {
            place: "centre",
            ...(lit(cell) ? extra : {}),
          }),
        ];
      }),
    );
    return [
      label(`row-${row}`, role, [middle(0), y(row)], hermiteSymbol(one), { place: "centre", ...extra }),
      ...cells,
      label(`live-${row}`, role, [middle(widths.length - 1), y(row)], last.cells[row]!, {
        place: "centre",
        ...extra,
      }),
    ];
  });
  return [
    ...heads,
    text("live", middle(widths.length - 1), y(-1), last.head),
    polyline("rule", "guide", [
      [0, y(-1) - height / 2],
      [1, y(-1) - height / 2],
    ]),
    ...rows,
  ];
}
