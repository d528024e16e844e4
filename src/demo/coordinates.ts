import { clamp, isNumberIn, MAX_TEXT, readNumber, roundTo, writeNumber } from "./number-text.ts";

/** Rows of numbers with `;` between rows and `,` between numbers: points, vectors, grids. */
export function writeRows(rows: readonly (readonly number[])[]): string {
  return rows.map((row) => row.map(writeNumber).join(",")).join(";");
}

/** Reads rows of numbers; null where a number cannot be read or the text is longer than anyone needs. */
export function readRows(text: string): number[][] | null {
  if (text.length > MAX_TEXT) return null;
  if (text === "") return [];
  const rows: number[][] = [];
  for (const part of text.split(";")) {
    const row: number[] = [];
    for (const word of part.split(",")) {
      const value = readNumber(word);
      if (value === null) return null;
      row.push(value);
    }
    rows.push(row);
  }
  return rows;
}

/** Whether something from outside is a list of rows of `dimension` numbers, each in its range. */
export function areRows(
  value: unknown,
  dimension: number,
  ranges: readonly (readonly [number, number])[],
): value is readonly (readonly number[])[] {
  return (
    Array.isArray(value) &&
    value.every(
      (row: unknown) =>
        Array.isArray(row) &&
        row.length === dimension &&
        row.every((entry, k) => isNumberIn(entry, ranges[k]![0], ranges[k]![1])),
    )
  );
}

/** A point brought into its ranges and rounded to the declared precision. */
export function place(
  point: readonly number[],
  ranges: readonly (readonly [number, number])[],
  decimals: number,
): readonly number[] {
  return ranges.map(([min, max], k) => clamp(roundTo(point[k] ?? 0, decimals), min, max));
}

/** The list with one entry replaced. */
export function replaced<T>(list: readonly T[], index: number, entry: T): readonly T[] {
  return list.map((old, i) => (i === index ? entry : old));
}
