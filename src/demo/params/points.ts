import { type Label, symbol } from "../../scene/label.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { areRows, place, readRows, replaced, writeRows } from "../coordinates.ts";
import { bad, type Field, good, type Handle, type Param } from "../param.ts";

/** A list of points of the plane. */
export type PointList = readonly (readonly number[])[];

export interface PointsOptions {
  readonly initial: PointList;
  /** How many points there may be. Default: exactly as many as at first. */
  readonly min?: number;
  readonly max?: number;
  readonly label: Words;
  /** The letter of the points: c for c₀, c₁, … */
  readonly letter?: string;
  /** Names of their own, where the points are not simply numbered. */
  readonly names?: readonly Label[];
  /** What the coordinates are called, where not x and y. */
  readonly axes?: readonly [string, string];
  /** The view in which the points are moved. Default: `plane`. */
  readonly view?: string;
  /** Where the points may be. Default: −20 … 20 in both directions. */
  readonly x?: readonly [number, number];
  readonly y?: readonly [number, number];
  /** Decimals that dragging keeps. */
  readonly precision?: number;
  /** Whether point i takes entry i of the index palette. Default: yes. */
  readonly indexed?: boolean;
}

/** Points of the plane that can be moved, added and taken away. */
export function points(options: PointsOptions): Param<PointList> {
  const { initial, label, letter = "c", names, view = "plane", precision = 2, indexed = true } = options;
  const axes = options.axes ?? ["x", "y"];
  const min = options.min ?? initial.length;
  const max = options.max ?? initial.length;
  const ranges = [options.x ?? [-20, 20], options.y ?? [-20, 20]] as const;
  const name = (i: number): Label => names?.[i] ?? symbol(letter, i);
  const step = 10 ** -precision;
  const refuse = () => {
    const count = min === max ? `${min}` : `${min}–${max}`;
    const span = (k: 0 | 1, lang: "de" | "en") => ranges[k].map((end) => formatNumber(end, lang)).join(" … ");
    return bad<PointList>(
      `erwartet werden ${count} Punkte x,y;x,y mit x in ${span(0, "de")} und y in ${span(1, "de")}`,
      `expected ${count} points x,y;x,y with x in ${span(0, "en")} and y in ${span(1, "en")}`,
    );
  };
  const check = (value: unknown) =>
    areRows(value, 2, ranges) && value.length >= min && value.length <= max
      ? good<PointList>(value.map((row) => [...row]))
      : refuse();
  return {
    type: "points",
    label,
    initial,
    read: (text) => {
      const rows = readRows(text);
      return rows ? check(rows) : refuse();
    },
    write: writeRows,
    accept: check,
    round: (value) => value.map((point) => place(point, ranges, precision)),
    between: (a, b, share) =>
      a.length === b.length
        ? a.map((p, i) => p.map((x, k) => x + (b[i]![k]! - x) * share))
        : share < 1
          ? a
          : b,
    handles: (id, value, { views }) =>
      value.map((at, i): Handle<PointList> => {
        const put = (to: readonly number[]) => replaced(value, i, place(to, ranges, precision));
        const window = views[view];
        const stride = window
          ? [(window.x[1] - window.x[0]) / 50, (window.y[1] - window.y[0]) / 50]
          : [0.1, 0.1];
        return {
          id: `${id}.${i}`,
          view,
          at,
          label: name(i),
          lettered: true,
          ...(indexed ? { index: i } : {}),
          put,
          nudge: ([dx, dy], factor) => {
            const by = (k: 0 | 1) => Math.max(step, stride[k]! * factor);
            return put([at[0]! + dx! * by(0), at[1]! + dy! * by(1)]);
          },
        };
      }),
    fields: (id, value) =>
      value.flatMap((at, i) =>
        axes.map((axis, k): Field<PointList> => {
          return {
            kind: "number",
            id: `${id}.${i}.${axis}`,
            group: name(i),
            label: symbol(axis),
            value: at[k]!,
            min: ranges[k]![0],
            max: ranges[k]![1],
            step,
            put: (next) => replaced(value, i, place(replaced(at, k, next), ranges, 12)),
          };
        }),
      ),
    actions: (value) =>
      min === max
        ? []
        : [
            {
              id: "add",
              label: { de: "Punkt anfügen", en: "Add a point" },
              value: value.length < max ? [...value, place(following(value), ranges, precision)] : null,
            },
            {
              id: "remove",
              label: { de: "Letzten Punkt entfernen", en: "Remove the last point" },
              value: value.length > min ? value.slice(0, -1) : null,
            },
          ],
    notation: () =>
      inBoth(
        (lang) =>
          `${min === max ? min : `${min}–${max}`} × x,y ${lang === "de" ? "getrennt durch" : "separated by"} ;`,
      ),
  };
}

/** Where a new last point starts: beyond the old one, turning back a little, so that it is seen. */
function following(value: PointList): readonly number[] {
  const last = value.at(-1) ?? [0, 0];
  const before = value.at(-2) ?? [last[0]! - 1, last[1]!];
  const [dx, dy] = [last[0]! - before[0]!, last[1]! - before[1]!];
  return [last[0]! - dy * 0.5 + dx * 0.25, last[1]! + dx * 0.5 + dy * 0.25];
}
