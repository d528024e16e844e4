import { expect, test } from "vitest";
import { bernstein, bezierPoint } from "../../src/math/index.ts";
import { bernsteinBand, bernsteinGraph } from "../../src/scene/bernstein-graph.ts";
import type { PathStep } from "../../src/scene/marks.ts";

const unit = (n: number, i: number) => Array.from({ length: n + 1 }, (_, k) => (k === i ? 1 : 0));

/** Points on the drawn pieces, three within each. */
function drawn(steps: readonly PathStep[]): number[][] {
  let from: readonly number[] = [0, 0];
  return steps.flatMap((step) => {
    if (step[0] === "Z") return [];
    const start = from;
    const points = step.slice(1) as (readonly number[])[];
    from = points.at(-1)!;
    return step[0] === "M" ? [] : [0.2, 0.5, 0.9].map((t) => [...bezierPoint([start, ...points], t)]);
  });
}

test.each([1, 2, 3])("up to degree 3 the graph is one exact Bézier arc (degree %i)", (n) => {
  for (let i = 0; i <= n; i++) {
    const steps = bernsteinGraph(unit(n, i));
    expect(steps).toHaveLength(2);
    for (const [t, value] of drawn(steps)) expect(value).toBeCloseTo(bernstein(n, i, t!), 12);
  }
});

test.each([4, 7, 20])("a graph of degree %i is drawn to a tenth of a pixel (of 400)", (n) => {
  for (let i = 0; i <= n; i++) {
    for (const [t, value] of drawn(bernsteinGraph(unit(n, i)))) {
      expect(Math.abs(value! - bernstein(n, i, t!))).toBeLessThan(2.5e-4);
    }
  }
});

test("a constant is a level line", () => {
  expect(bernsteinGraph([2, 2])).toEqual([
    ["M", [0, 2]],
    ["L", [1, 2]],
  ]);
});

test.each([1, 3, 6])("a band runs along the upper graph and back along the lower one (degree %i)", (n) => {
  const low = unit(n, 0);
  const high = low.map(() => 1);
  const band = bernsteinBand(low, high);
  expect(band[0]).toEqual(["M", [0, 1]]);
  expect(band.at(-1)).toEqual(["Z"]);
  const there = drawn(band.slice(0, (band.length - 1) / 2));
  const back = drawn(band).slice(there.length + 3);
  for (const [, value] of there) expect(value).toBeCloseTo(1, 12);
  expect(back.length).toBeGreaterThan(0);
  for (const [t, value] of back) expect(value).toBeCloseTo(bernstein(n, 0, t!), 3);
});
