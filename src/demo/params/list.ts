import { type Label, symbol } from "../../scene/label.ts";
import type { XY } from "../../scene/marks.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { areRows, readRows, replaced, writeRows } from "../coordinates.ts";
import { clamp, roundTo } from "../number-text.ts";
import { bad, type Field, good, type Handle, type Param, type State } from "../param.ts";

export type NumberList = readonly number[];

export interface ListOptions {
  readonly initial: NumberList;
  /** How many entries there may be. Default: exactly as many as at first. */
  readonly min?: number;
  readonly max?: number;
  /** The range of an entry. */
  readonly range: readonly [number, number];
  readonly label: Words;
  readonly letter: string;
  readonly precision?: number;
  readonly indexed?: boolean;
  /** Handles in a view: where entry i is, and which number a point means for it. */
  readonly handle?: {
    readonly view: string;
    readonly at: (index: number, state: State) => XY;
    readonly from: (point: XY, index: number, state: State) => number;
  };
}

/** A list of numbers: nodes, knots, weights, values. */
export function list(options: ListOptions): Param<NumberList> {
  const { initial, label, letter, range, precision = 2, indexed = false, handle } = options;
  const min = options.min ?? initial.length;
  const max = options.max ?? initial.length;
  const near = (value: number) => clamp(roundTo(value, precision), range[0], range[1]);
  const name = (i: number): Label => symbol(letter, i);
  const count = min === max ? `${min}` : `${min}–${max}`;
  const refuse = () => {
    const span = (lang: "de" | "en") => range.map((end) => formatNumber(end, lang)).join(" … ");
    return bad<NumberList>(
      `erwartet werden ${count} Zahlen a,b,c im Bereich ${span("de")}`,
      `expected ${count} numbers a,b,c in ${span("en")}`,
    );
  };
  const check = (value: unknown) =>
    Array.isArray(value) &&
    value.length >= min &&
    value.length <= max &&
    areRows([value], value.length, Array(value.length).fill(range))
      ? good<NumberList>([...(value as NumberList)])
      : refuse();
  return {
    type: "list",
    label,
    initial,
    read: (text) => {
      const rows = readRows(text);
      return rows && rows.length <= 1 ? check(rows[0] ?? []) : refuse();
    },
    write: (value) => writeRows([value]),
    accept: check,
    round: (value) => value.map(near),
    between: (a, b, share) =>
      a.length === b.length ? a.map((x, i) => x + (b[i]! - x) * share) : share < 1 ? a : b,
    handles: (id, value, { state }) =>
      handle
        ? value.map((entry, i): Handle<NumberList> => {
            const put = (next: number) => replaced(value, i, near(next));
            return {
              id: `${id}.${i}`,
              view: handle.view,
              at: handle.at(i, state),
              label: name(i),
              ...(indexed ? { index: i } : {}),
              put: (to) => put(handle.from(to, i, state)),
              nudge: ([dx, dy], factor) =>
                put(entry + (dx! + dy!) * Math.max(10 ** -precision, ((range[1] - range[0]) / 50) * factor)),
            };
          })
        : [],
    fields: (id, value) =>
      value.map(
        (entry, i): Field<NumberList> => ({
          kind: "number",
          id: `${id}.${i}`,
          label: name(i),
          value: entry,
          min: range[0],
          max: range[1],
          step: 10 ** -precision,
          put: (next) => replaced(value, i, clamp(next, range[0], range[1])),
        }),
      ),
    actions: (value) =>
      min === max
        ? []
        : [
            {
              id: "add",
              label: { de: "Zahl anfügen", en: "Add a number" },
              value: value.length < max ? [...value, near(value.at(-1) ?? range[0])] : null,
            },
            {
              id: "remove",
              label: { de: "Letzte Zahl entfernen", en: "Remove the last number" },
              value: value.length > min ? value.slice(0, -1) : null,
            },
          ],
    notation: () =>
      inBoth((lang) => `${count} × ${lang === "de" ? "Zahl, getrennt durch" : "number, separated by"} ,`),
  };
}
