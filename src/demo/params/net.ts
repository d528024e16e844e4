import { symbol } from "../../scene/label.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { areRows, place, readRows, replaced, writeRows } from "../coordinates.ts";
import { MAX_TEXT } from "../number-text.ts";
import { bad, type Field, good, type Handle, type Param } from "../param.ts";

/** Rows of points: `net[i][j]`, i with u and j with v. */
export type Net = readonly (readonly (readonly number[])[])[];

export interface NetOptions {
  readonly initial: Net;
  readonly label: Words;
  readonly letter?: string;
  readonly view?: string;
  /** The range of every coordinate. Default −20 … 20. */
  readonly range?: readonly [number, number];
  readonly precision?: number;
}

/** A control net of fixed size, of points in the plane or in space. */
export function net(options: NetOptions): Param<Net> {
  const { initial, label, letter = "c", view = "space", range = [-20, 20], precision = 2 } = options;
  const rows = initial.length;
  const columns = initial[0]!.length;
  const dimension = initial[0]![0]!.length;
  const ranges = Array(dimension).fill(range) as (readonly [number, number])[];
  const shape = Array(dimension)
    .fill("x")
    .map((_, k) => "xyz"[k])
    .join(",");
  const refuse = () => {
    const span = (lang: "de" | "en") => range.map((end) => formatNumber(end, lang)).join(" … ");
    return bad<Net>(
      `erwartet werden ${rows} Zeilen zu ${columns} Punkten ${shape};${shape}/… im Bereich ${span("de")}`,
      `expected ${rows} rows of ${columns} points ${shape};${shape}/… in ${span("en")}`,
    );
  };
  const check = (value: unknown) =>
    Array.isArray(value) &&
    value.length === rows &&
    value.every((row) => areRows(row, dimension, ranges) && row.length === columns)
      ? good<Net>((value as Net).map((row) => row.map((point) => [...point])))
      : refuse();
  const at = (value: Net, i: number, j: number, point: readonly number[]): Net =>
    replaced(value, i, replaced(value[i]!, j, point));
  return {
    type: "net",
    label,
    initial,
    read: (text) => {
      if (text.length > MAX_TEXT) return refuse();
      const read = text.split("/").map(readRows);
      return read.includes(null) ? refuse() : check(read);
    },
    write: (value) => value.map(writeRows).join("/"),
    accept: check,
    round: (value) => value.map((row) => row.map((point) => place(point, ranges, precision))),
    between: (a, b, share) =>
      a.map((row, i) => row.map((point, j) => point.map((x, k) => x + (b[i]![j]![k]! - x) * share))),
    handles: (id, value, { views }) => {
      const window = views[view];
      const stride = window ? (window.x[1] - window.x[0]) / 50 : 0.1;
      return value.flatMap((row, i) =>
        row.map((point, j): Handle<Net> => {
          // A point in space keeps the coordinates that the view cannot change.
          const put = (to: readonly number[]) =>
            at(
              value,
              i,
              j,
              // What does not move keeps its very number, even one with more decimals than dragging leaves.
              place(
                point.map((x, k) => to[k] ?? x),
                ranges,
                precision,
              ).map((x, k) => (Object.is(to[k] ?? point[k], point[k]) ? point[k]! : x)),
            );
          return {
            id: `${id}.${i * columns + j}`,
            view,
            at: point,
            label: symbol(letter, `${i}${j}`),
            put,
            nudge: (direction, factor) =>
              put(point.map((x, k) => x + (direction[k] ?? 0) * Math.max(10 ** -precision, stride * factor))),
          };
        }),
      );
    },
    fields: (id, value) =>
      value.flatMap((row, i) =>
        row.flatMap((point, j) =>
          point.map(
            (entry, k): Field<Net> => ({
              kind: "number",
              id: `${id}.${i * columns + j}.${"xyz"[k]}`,
              group: symbol(letter, `${i}${j}`),
              label: symbol("xyz"[k]!),
              value: entry,
              min: range[0],
              max: range[1],
              step: 10 ** -precision,
              put: (next) => at(value, i, j, place(replaced(point, k, next), ranges, 12)),
            }),
          ),
        ),
      ),
    actions: () => [],
    notation: () =>
      inBoth(
        (lang) =>
          `${rows} × ${columns} × ${shape}, ${lang === "de" ? "Punkte getrennt durch ; Zeilen durch" : "points separated by ; rows by"} /`,
      ),
  };
}
