import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { LOGO_POINTS, logoPath } from "../../src/build/templates/logo.ts";
import { picture } from "../../src/build/templates/pictures/index.ts";
import { type Arc, arcsOf, secondDerivatives } from "./path-data.ts";

const pathOf = (markup: string, name: string) =>
  new RegExp(`class="${name}" d="([^"]+)"`).exec(markup)?.[1] ?? "";

/** Path data is rounded to so many pixels; second derivatives amplify that. */
function expectNaturalSpline(arcs: readonly Arc[], within: number): void {
  for (const arc of arcs) {
    const [x0, x1, x2, x3] = arc.map((point) => point[0]!) as [number, number, number, number];
    expect(Math.abs(x1 - (2 * x0 + x3) / 3)).toBeLessThan(0.1);
    expect(Math.abs(x2 - (x0 + 2 * x3) / 3)).toBeLessThan(0.1);
  }
  for (const [i, arc] of arcs.slice(1).entries()) {
    const before = arcs[i]!;
    expect(arc[0]).toEqual(before[3]);
    const slope = (a: readonly number[], b: readonly number[]) => (b[1]! - a[1]!) / (b[0]! - a[0]!);
    expect(Math.abs(slope(before[2]!, before[3]!) - slope(arc[0]!, arc[1]!))).toBeLessThan(10 * within);
    expect(Math.abs(secondDerivatives(before)[1] - secondDerivatives(arc)[0])).toBeLessThan(within);
  }
  expect(Math.abs(secondDerivatives(arcs[0]!)[0])).toBeLessThan(within);
  expect(Math.abs(secondDerivatives(arcs.at(-1)!)[1])).toBeLessThan(within);
  expect(arcs.some((arc) => Math.abs(secondDerivatives(arc)[0]) > 5 * within)).toBe(true);
}

describe("what looks like a spline is one", () => {
  test("the logo: C² at its weights, straight at its ends", () => {
    const arcs = arcsOf(logoPath());
    expect(arcs.map((arc) => arc[0])).toEqual(LOGO_POINTS.slice(0, -1).map((point) => [...point]));
    expectNaturalSpline(arcs, 2e-3);
  });

  test("the icon", () => {
    const icon = readFileSync("public/icon.svg", "utf8");
    expectNaturalSpline(arcsOf(/<path d="([^"]+)"/.exec(icon)![1]!), 5e-3);
  });

  test("the lath of the front page", () => {
    expectNaturalSpline(arcsOf(pathOf(picture("ships"), "p-lath")), 1e-4);
  });
});

describe("arcs of a chain meet without a kink", () => {
  for (const name of ["cad", "design"] as const) {
    test(name, () => {
      const arcs = arcsOf(pathOf(picture(name), "p-curve"));
      expect(arcs).toHaveLength(3);
      for (const [i, arc] of arcs.slice(1).entries()) {
        const [a, b] = [arcs[i]![2]!, arcs[i]![3]!];
        const c = arc[1]!;
        const incoming = [b[0]! - a[0]!, b[1]! - a[1]!] as const;
        const outgoing = [c[0]! - b[0]!, c[1]! - b[1]!] as const;
        const lengths = Math.hypot(...incoming) * Math.hypot(...outgoing);
        const sine = (incoming[0] * outgoing[1] - incoming[1] * outgoing[0]) / lengths;
        const cosine = (incoming[0] * outgoing[0] + incoming[1] * outgoing[1]) / lengths;
        expect(Math.abs(sine)).toBeLessThan(0.02);
        expect(cosine).toBeGreaterThan(0);
      }
    });
  }
});
