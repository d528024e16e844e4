import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { coverageOf, coverageText } from "../../src/build/coverage.ts";
import { openSite } from "../../src/build/site.ts";
import type { Draw, Side } from "../../src/identities/identity.ts";
import { identities } from "../../src/identities/index.ts";

const RUNS = 200;
const root = new URL("../../", import.meta.url).pathname;

/** Random numbers that are the same in every run (mulberry32), so that a failure can be repeated. */
function drawFrom(seed: number): Draw {
  let state = seed >>> 0;
  const next = () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let x = Math.imul(state ^ (state >>> 15), 1 | state);
    x = (x + Math.imul(x ^ (x >>> 7), 61 | x)) ^ x;
    return ((x ^ (x >>> 14)) >>> 0) / 2 ** 32;
  };
  const number = (min: number, max: number) => min + (max - min) * next();
  return {
    number,
    integer: (min, max) => Math.floor(number(min, max + 1)),
    points: (count, dimension = 2) =>
      Array.from({ length: count }, () => Array.from({ length: dimension }, () => number(-10, 10))),
  };
}

const numbers = (side: Side): number[] => (typeof side === "number" ? [side] : side.flatMap(numbers));

/** The largest difference of two sides, relative to the size of what stands on them; ∞ if their shapes differ. */
function difference(a: Side, b: Side): number {
  const [left, right] = [numbers(a), numbers(b)];
  if (left.length !== right.length || left.length === 0) return Infinity;
  const size = Math.max(1, ...left.map(Math.abs));
  return Math.max(...left.map((x, i) => Math.abs(x - right[i]!))) / size;
}

describe("each formula of a lesson holds in the mathematics that the figures run", () => {
  test.each(Object.entries(identities))("%s", (_, { sides, tolerance = 1e-9 }) => {
    for (let seed = 0; seed < RUNS; seed++) {
      for (const [left, right] of sides(drawFrom(seed))) {
        const found = difference(left, right);
        expect(
          found,
          `seed ${seed}: ${JSON.stringify(left)} against ${JSON.stringify(right)}`,
        ).toBeLessThanOrEqual(tolerance);
      }
    }
  });
});

describe("the comparison can fail", () => {
  test.each(Object.entries(identities))(
    "%s: a side that is a little off is seen",
    (_, { sides, tolerance = 1e-9 }) => {
      const [[left]] = sides(drawFrom(1)) as [[Side, Side]];
      const shifted = (side: Side): Side =>
        typeof side === "number" ? side + 20 * tolerance * (1 + Math.abs(side)) : side.map(shifted);
      expect(difference(left, shifted(left))).toBeGreaterThan(tolerance);
    },
  );

  test("sides of different shape differ", () => {
    expect(difference([1, 2], [1])).toBe(Infinity);
    expect(difference(Number.NaN, 1)).toBeNaN();
  });
});

test("at least nine of ten displayed formulas carry a check; what the build counts is what the lessons hold", async () => {
  const { coverage } = await openSite({ root, policy: false, siteUrl: null });
  const displayed = readdirSync(`${root}lessons`, { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => readFileSync(`${root}lessons/${name}/de.md`, "utf8"))
    .flatMap((text) => [...text.matchAll(/^\$\$\s*$/gm)]).length;
  const notations = displayed / 2 - coverage.total;
  expect(notations).toBeGreaterThanOrEqual(0);
  // A formula that states nothing is the exception.
  expect(notations / (displayed / 2)).toBeLessThan(0.25);
  expect(coverage.total).toBeGreaterThan(0);
  expect(coverage.covered / coverage.total, coverageText(coverage)).toBeGreaterThanOrEqual(0.9);
});

test("formulas without a check are counted, notation is not", () => {
  const formulas = [
    { line: 1, check: "a", notation: false },
    { line: 2, check: null, notation: false },
    { line: 3, check: null, notation: true },
  ];
  const lesson = (lang: string) => ({ lang, file: `${lang}.md`, formulas });
  const coverage = coverageOf([lesson("de"), lesson("en")] as unknown as Parameters<typeof coverageOf>[0]);
  expect(coverage).toEqual({ covered: 1, total: 2, open: [{ file: "de.md", line: 2 }] });
  expect(coverageText(coverage)).toBe("identities: 1 of 2 displayed formulas carry a check (50 %)");
});
