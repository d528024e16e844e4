import type { Point } from "./point.ts";

/*
 * Checks of arguments, shared by everything that builds or evaluates from a caller's data. Each throws a
 * `RangeError` that names the argument, the index and the value: `controlPoints[2][1]: expected a finite number,
 * got NaN`.
 */

function fail(where: string, expected: string, got: unknown): never {
  throw new RangeError(`${where}: expected ${expected}, got ${show(got)}`);
}

function show(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(show).join(", ")}]`;
  return typeof value === "string" ? `"${value}"` : String(value);
}

/** Demands a finite number. */
export function checkNumber(name: string, value: number): void {
  if (!Number.isFinite(value)) fail(name, "a finite number", value);
}

/** Demands a finite number greater than 0 (a tolerance, an accuracy, a length). */
export function checkPositive(name: string, value: number): void {
  if (!(Number.isFinite(value) && value > 0)) fail(name, "a positive finite number", value);
}

/** Demands a whole number with minimum ≤ value ≤ maximum (a degree, a count, an index). */
export function checkInteger(
  name: string,
  value: number,
  minimum: number,
  maximum = Number.MAX_SAFE_INTEGER,
): void {
  if (!(Number.isSafeInteger(value) && value >= minimum && value <= maximum)) {
    const range =
      maximum === Number.MAX_SAFE_INTEGER ? `of at least ${minimum}` : `from ${minimum} to ${maximum}`;
    fail(name, `a whole number ${range}`, value);
  }
}

/** Demands a list of at least `minimum` finite numbers. */
export function checkNumbers(name: string, values: ArrayLike<number>, minimum = 1): void {
  checkCount(name, values, minimum, "number");
  for (let i = 0; i < values.length; i++) {
    if (!Number.isFinite(values[i])) fail(`${name}[${i}]`, "a finite number", values[i]);
  }
}

/** Demands a point of finite coordinates, of the given dimension if one is given. */
export function checkPoint(name: string, point: Point, dimension?: number): void {
  if (!Array.isArray(point)) fail(name, "a point (a list of coordinates)", point);
  if (point.length === 0) fail(name, "at least one coordinate", point);
  if (dimension !== undefined && point.length !== dimension) {
    fail(name, `${dimension} coordinate${dimension === 1 ? "" : "s"}`, point);
  }
  for (let i = 0; i < point.length; i++) {
    if (!Number.isFinite(point[i])) fail(`${name}[${i}]`, "a finite number", point[i]);
  }
}

/**
 * Demands at least `minimum` points of finite coordinates and of one dimension.
 *
 * @returns the dimension.
 */
export function checkPoints(name: string, points: readonly Point[], minimum = 1, dimension?: number): number {
  checkCount(name, points, minimum, "point");
  let common = dimension;
  for (let i = 0; i < points.length; i++) {
    checkPoint(`${name}[${i}]`, points[i]!, common);
    common ??= points[i]!.length;
  }
  return common!;
}

/** Demands that two lists belong to each other entry by entry. */
export function checkSameLength(
  name: string,
  list: { readonly length: number },
  otherName: string,
  other: { readonly length: number },
): void {
  if (list.length !== other.length) {
    throw new RangeError(
      `${name}: expected ${other.length} entries, one for each of ${otherName}, got ${list.length}`,
    );
  }
}

/** Demands finite numbers of which no two are equal (interpolation nodes, in any order). */
export function checkDistinct(name: string, values: ArrayLike<number>, minimum = 1): void {
  checkNumbers(name, values, minimum);
  const seen = new Map<number, number>();
  for (let i = 0; i < values.length; i++) {
    const before = seen.get(values[i]!);
    if (before !== undefined) fail(`${name}[${i}]`, `a value different from ${name}[${before}]`, values[i]);
    seen.set(values[i]!, i);
  }
}

/** Demands finite numbers in strictly ascending order (abscissae of a spline, breaks). */
export function checkAscending(name: string, values: ArrayLike<number>, minimum = 1): void {
  checkNumbers(name, values, minimum);
  for (let i = 1; i < values.length; i++) {
    if (!(values[i]! > values[i - 1]!)) {
      fail(`${name}[${i}]`, `a number greater than ${name}[${i - 1}] = ${values[i - 1]}`, values[i]);
    }
  }
}

/** Demands finite numbers of which none is smaller than the one before (a knot vector). */
export function checkNonDecreasing(name: string, values: ArrayLike<number>, minimum = 1): void {
  checkNumbers(name, values, minimum);
  for (let i = 1; i < values.length; i++) {
    if (values[i]! < values[i - 1]!) {
      fail(`${name}[${i}]`, `a number of at least ${name}[${i - 1}] = ${values[i - 1]}`, values[i]);
    }
  }
}

/** Demands `count` finite weights of which at least one is not 0; negative weights are allowed. */
export function checkWeights(name: string, weights: readonly number[], count: number): void {
  checkNumbers(name, weights);
  if (weights.length !== count) {
    throw new RangeError(
      `${name}: expected ${count} weights, one for each control point, got ${weights.length}`,
    );
  }
  if (weights.every((weight) => weight === 0)) fail(name, "at least one weight other than 0", weights);
}

/** Demands an interval [a, b] of finite numbers with a < b. */
export function checkInterval(name: string, interval: readonly [number, number]): void {
  if (!Array.isArray(interval) || interval.length !== 2) fail(name, "an interval [a, b]", interval);
  checkAscending(name, interval);
}

function checkCount(name: string, list: ArrayLike<unknown>, minimum: number, noun: string): void {
  if (!Array.isArray(list) && !ArrayBuffer.isView(list)) fail(name, `a list of ${noun}s`, list);
  if (list.length < minimum) {
    const got = list.length === 0 ? "none" : String(list.length);
    throw new RangeError(
      `${name}: expected at least ${minimum} ${noun}${minimum === 1 ? "" : "s"}, got ${got}`,
    );
  }
}
