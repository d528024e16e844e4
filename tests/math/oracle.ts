import { readdirSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";

/**
 * Maps each `op` to the module: input in, result in the shape of `expect` out; a `RangeError` means "undefined".
 *
 * The input arrives as the README of the data describes it; each function declares the shape it reads.
 */
export type Adapter = Readonly<Record<string, (input: never) => unknown>>;

export type Tolerance = { readonly abs: number; readonly rel: number };

export type OracleCase = {
  readonly name: string;
  readonly input: { readonly op: string; readonly [argument: string]: unknown };
  readonly expect: unknown;
  readonly tolerance: Tolerance;
};

export type OracleFile = {
  readonly file: string;
  readonly topic: string;
  readonly cases: readonly OracleCase[];
};

/** All data sets of a folder; an empty folder is an error, since it would test nothing. */
export function readOracles(folder: string): OracleFile[] {
  const path = resolve(folder);
  const files = readdirSync(path).filter((name) => name.endsWith(".json"));
  if (files.length === 0)
    throw new Error(`${path}: no *.json with reference data; set ORACLES to their folder`);
  return files.sort().map((file) => ({ file, ...JSON.parse(readFileSync(join(path, file), "utf8")) }));
}

/** Runs one case; the list of differences is empty when it passes. */
export function runCase(adapter: Adapter, { input, expect, tolerance }: OracleCase): string[] {
  const run = Object.hasOwn(adapter, input.op) ? adapter[input.op] : undefined;
  if (run === undefined) return [`unknown op "${input.op}": add it to an adapter in tests/math/oracles/`];
  const undefinedProblem = isObject(expect) && typeof expect.undefined === "string";
  let actual: unknown;
  try {
    actual = run(input as never);
  } catch (error) {
    if (!(error instanceof RangeError)) throw error;
    return undefinedProblem ? [] : [`threw RangeError: ${error.message}`];
  }
  if (undefinedProblem) {
    return absent(actual) ? [] : [`expected no result (${expect.undefined}), got ${JSON.stringify(actual)}`];
  }
  return differences(actual, expect, tolerance);
}

/** Every place where `actual` misses `expected`, compared as `tests/oracles/README.md` says. */
export function differences(
  actual: unknown,
  expected: unknown,
  tolerance: Tolerance,
  path = "result",
): string[] {
  const miss = (): string[] => [`${path}: expected ${JSON.stringify(expected)}, got ${show(actual)}`];
  if (expected === null) return absent(actual) ? [] : miss();
  if (typeof expected === "number") {
    if (typeof actual !== "number" || !Number.isFinite(actual)) return miss();
    return Math.abs(actual - expected) <= tolerance.abs + tolerance.rel * Math.abs(expected) ? [] : miss();
  }
  if (Array.isArray(expected)) {
    if (!Array.isArray(actual) || actual.length !== expected.length) return miss();
    return expected.flatMap((value, i) => differences(actual[i], value, tolerance, `${path}[${i}]`));
  }
  if (isObject(expected)) {
    if (!isObject(actual)) return miss();
    return Object.entries(expected).flatMap(([key, value]) =>
      differences(actual[key], value, tolerance, `${path}.${key}`),
    );
  }
  return actual === expected ? [] : miss();
}

function absent(value: unknown): boolean {
  return value === null || value === undefined || value instanceof RangeError;
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function show(value: unknown): string {
  return typeof value === "number" ? String(value) : (JSON.stringify(value) ?? String(value));
}
