import { formatNumber } from "../../words/numbers.ts";
import type { Words } from "../../words/words.ts";
import { areRows, place, readRows, writeRows } from "../coordinates.ts";
import { bad, good, type Param } from "../param.ts";
import type { PointList } from "./points.ts";

export interface StrokeOptions {
  readonly label: Words;
  readonly view?: string;
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
  /** How many points are kept at the most; a longer line is thinned out. Default 200. */
  readonly max?: number;
  readonly precision?: number;
}

/** A line drawn with the pencil: a list of points, empty at first. */
export function stroke(options: StrokeOptions): Param<PointList> {
  const { label, view = "plane", x, y, max = 200, precision = 2 } = options;
  const ranges = [x, y] as const;
  const refuse = () => {
    const span = (lang: "de" | "en") =>
      [x, y].map((range) => range.map((end) => formatNumber(end, lang)).join(" … ")).join(" × ");
    return bad<PointList>(
      `erwartet werden höchstens ${max} Punkte x,y;x,y in ${span("de")}`,
      `expected at most ${max} points x,y;x,y in ${span("en")}`,
    );
  };
  const check = (value: unknown) =>
    areRows(value, 2, ranges) && value.length <= max
      ? good<PointList>(value.map((row) => [...row]))
      : refuse();
  return {
    type: "stroke",
    label,
    initial: [],
    drawnIn: view,
    read: (text) => {
      const rows = readRows(text);
      return rows ? check(rows) : refuse();
    },
    write: writeRows,
    accept: check,
    round: (value) => thinned(value, max).map((point) => place(point, ranges, precision)),
    between: (a, b, share) => (share < 1 ? a : b),
    handles: () => [],
    fields: () => [],
    actions: (value) => [
      {
        id: "clear",
        label: { de: "Zeichnung löschen", en: "Clear the drawing" },
        value: value.length > 0 ? [] : null,
      },
    ],
    notation: () => ({ de: `bis ${max} × x,y getrennt durch ;`, en: `up to ${max} × x,y separated by ;` }),
  };
}

/** At most `max` of the points, evenly taken, the first and the last among them. */
function thinned(value: PointList, max: number): PointList {
  if (value.length <= max) return value;
  return Array.from({ length: max }, (_, i) => value[Math.round((i * (value.length - 1)) / (max - 1))]!);
}
