import { symbol } from "../../scene/label.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { areRows, readRows, replaced, writeRows } from "../coordinates.ts";
import { clamp, roundTo } from "../number-text.ts";
import { bad, type Field, good, type Param } from "../param.ts";

export type Grid = readonly (readonly number[])[];

export interface GridOptions {
  readonly initial: Grid;
  readonly label: Words;
  readonly letter: string;
  readonly range: readonly [number, number];
  readonly precision?: number;
}

/** A rectangle of numbers of fixed size: grid values, a matrix. Row by row, `a,b;c,d`. */
export function grid(options: GridOptions): Param<Grid> {
  const { initial, label, letter, range, precision = 2 } = options;
  const rows = initial.length;
  const columns = initial[0]!.length;
  const ranges = Array(columns).fill(range) as (readonly [number, number])[];
  const refuse = () => {
    const span = (lang: "de" | "en") => range.map((end) => formatNumber(end, lang)).join(" … ");
    return bad<Grid>(
      `erwartet werden ${rows} Zeilen zu ${columns} Zahlen a,b;c,d im Bereich ${span("de")}`,
      `expected ${rows} rows of ${columns} numbers a,b;c,d in ${span("en")}`,
    );
  };
  const check = (value: unknown) =>
    areRows(value, columns, ranges) && value.length === rows
      ? good<Grid>(value.map((row) => [...row]))
      : refuse();
  return {
    type: "grid",
    label,
    initial,
    read: (text) => {
      const read = readRows(text);
      return read ? check(read) : refuse();
    },
    write: writeRows,
    accept: check,
    round: (value) => value.map((row) => row.map((x) => clamp(roundTo(x, precision), range[0], range[1]))),
    between: (a, b, share) => a.map((row, i) => row.map((x, j) => x + (b[i]![j]! - x) * share)),
    handles: () => [],
    fields: (id, value) =>
      value.flatMap((row, i) =>
        row.map(
          (entry, j): Field<Grid> => ({
            kind: "number",
            id: `${id}.${i * columns + j}`,
            group: symbol(letter, `${i}·`),
            label: symbol(letter, `${i}${j}`),
            value: entry,
            min: range[0],
            max: range[1],
            step: 10 ** -precision,
            put: (next) => replaced(value, i, replaced(row, j, clamp(next, range[0], range[1]))),
          }),
        ),
      ),
    actions: () => [],
    notation: () =>
      inBoth(
        (lang) =>
          `${rows} × ${columns} ${lang === "de" ? "Zahlen, Zeilen getrennt durch" : "numbers, rows separated by"} ;`,
      ),
  };
}
