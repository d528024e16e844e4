import { describe, expect, test } from "vitest";
import type { Demo } from "../../src/demo/index.ts";
import { changed, initialState } from "../../src/demo/state.ts";
import hermiteBasis from "../../src/demos/hermite-basis.ts";
import hermiteSegment from "../../src/demos/hermite-segment.ts";
import {
  bezierExtrema,
  bezierPoint,
  hermitePolynomial,
  hermiteSpline,
  lagrangeBasis,
  norm,
  type Point,
} from "../../src/math/index.ts";
import { evenly } from "../../src/scene/hermite-steps.ts";

// The numbers and claims of the lesson's text, read from the figures it talks about.

function values(demo: Demo, patch: Record<string, unknown> = {}) {
  return demo.values(changed(demo, initialState(demo), patch));
}
const named = (name: string) => hermiteSegment.states![name] as Record<string, unknown>;

test("the weights at 0.4 are 0.648, 0.144, −0.096, 0.352, together 1.048", () => {
  const weights = values(hermiteSegment, { t: 0.4 }).weights as number[];
  [0.648, 0.144, -0.096, 0.352].forEach((weight, i) => {
    expect(weights[i]).toBeCloseTo(weight, 12);
  });
  expect(weights.reduce((sum, weight) => sum + weight, 0)).toBeCloseTo(1.048, 12);
});

test("at ½ the weights are ½, ⅛, −⅛, ½, and the curve is at (0.6, 0.5)", () => {
  const { weights, p } = values(hermiteSegment, { t: 0.5 });
  expect(weights).toEqual([0.5, 0.125, -0.125, 0.5]);
  expect((p as number[])[0]).toBeCloseTo(0.6, 12);
  expect((p as number[])[1]).toBeCloseTo(0.5, 12);
});

describe("the bulge", () => {
  const top = (patch: Record<string, unknown>) => {
    const c = values(hermiteSegment, patch).c as Point[];
    return bezierPoint(c, bezierExtrema(c)[1]![0]!);
  };

  test("is above the middle at first, at (0.6, 0.5)", () => {
    expect(top({})[0]).toBeCloseTo(0.6, 12);
    expect(top({})[1]).toBeCloseTo(0.5, 12);
  });

  test("goes to (0.73, 0.66) when m₀ is doubled, near t = 0.42", () => {
    const doubled = named("doubled");
    expect(doubled.m0).toEqual([3, 2.4]);
    expect(top(doubled)[0]).toBeCloseTo(0.73, 2);
    expect(top(doubled)[1]).toBeCloseTo(0.66, 2);
    expect(bezierExtrema(values(hermiteSegment, doubled).c as Point[])[1]![0]).toBeCloseTo(0.42, 2);
  });
});

test("H₁ is largest at ⅓ with 4/27, H₂ least at ⅔ with −4/27", () => {
  const at = (t: number) => values(hermiteSegment, { t }) as { weights: number[]; slopes: number[] };
  expect(at(1 / 3).weights[1]).toBeCloseTo(4 / 27, 12);
  expect(at(1 / 3).slopes[1]).toBeCloseTo(0, 12);
  expect(at(2 / 3).weights[2]).toBeCloseTo(-4 / 27, 12);
  expect(at(2 / 3).slopes[2]).toBeCloseTo(0, 12);
});

describe("too long tangents", () => {
  const with_ = (a: number) => values(hermiteSegment, { ...named("loop"), m0: [a, 2], m1: [a, -2] });

  test("an arch below three times the distance, a cusp there, a loop above", () => {
    expect(with_(0.9).kind).toBe("none");
    const cusp = with_(1.8);
    expect(cusp.kind).toBe("cusp");
    expect((cusp.parameters as number[])[0]).toBeCloseTo(0.5, 9);
    expect(norm(cusp.derivative as Point)).toBeCloseTo(0, 12);
    expect(with_(2.7).kind).toBe("node");
  });

  test("the loop passes its double point at 0.17 and 0.83", () => {
    const [s, t] = with_(2.7).parameters as number[];
    expect(s).toBeCloseTo(0.17, 2);
    expect(t).toBeCloseTo(0.83, 2);
  });

  test("in the middle the horizontal velocity is (3d − a)/2", () => {
    for (const a of [0.9, 1.8, 2.7])
      expect((with_(a).derivative as number[])[0]).toBeCloseTo((3 * 0.6 - a) / 2, 12);
  });

  test("at the cusp the second derivative points down, the third is level", () => {
    const [a3, a2] = values(hermiteSegment, named("cusp")).coefficients as [Point, Point];
    const second = a3.map((x, k) => 3 * x + 2 * a2[k]!);
    expect(second[0]).toBeCloseTo(0, 12);
    expect(second[1]).toBeLessThan(0);
    expect(a3[0]).toBeGreaterThan(0);
    expect(a3[1]).toBeCloseTo(0, 12);
  });
});

describe("the script's example", () => {
  const script = named("script");

  test("p(½) is (0.75, 0.5), the coefficients are (−2, −2), (2, 3), (1, 0), (0, 0)", () => {
    const { p, coefficients } = values(hermiteSegment, script);
    expect(p).toEqual([0.75, 0.5]);
    const written = [
      [-2, -2],
      [2, 3],
      [1, 0],
      [0, 0],
    ];
    (coefficients as Point[]).forEach((point, i) => {
      point.forEach((x, k) => {
        expect(x).toBeCloseTo(written[i]![k]!, 12);
      });
    });
  });

  test("it turns right of p₁, at t ≈ 0.8604 and x ≈ 1.0671, where 1 + 4t − 6t² vanishes", () => {
    const c = values(hermiteSegment, script).c as Point[];
    const [t] = bezierExtrema(c)[0]!;
    expect(t).toBeCloseTo(0.8604, 4);
    expect(1 + 4 * t! - 6 * t! ** 2).toBeCloseTo(0, 12);
    expect(bezierPoint(c, t!)[0]).toBeCloseTo(1.0671, 4);
  });
});

test("the slider of the length keeps the direction, the handle sets the length", () => {
  const longer = changed(hermiteSegment, initialState(hermiteSegment), { length: 3 });
  const m0 = longer.m0 as number[];
  expect(norm(m0)).toBeCloseTo(3, 12);
  expect(m0[0]! / m0[1]!).toBeCloseTo(1.5 / 1.2, 12);
  expect(changed(hermiteSegment, longer, { m0: [0, 4] }).length).toBe(4);
  // From a tangent that is gone the direction of the chord is taken.
  const gone = changed(hermiteSegment, longer, { m0: [0, 0] });
  expect(changed(hermiteSegment, gone, { length: 2 }).m0).toEqual([2, 0]);
});

test("the lengths 1, 2, 3 and 6 of the text are these", () => {
  for (const [m0, length] of [
    [[0.6, 0.8], 1],
    [[1.2, 1.6], 2],
    [[1.8, 2.4], 3],
    [[3.6, 4.8], 6],
  ] as const) {
    expect(changed(hermiteSegment, initialState(hermiteSegment), { m0 }).length).toBeCloseTo(length, 12);
  }
});

test.each([0, 1, 2, 3, 4, 5])("order %i: a single one in each row, on any interval", (m) => {
  for (const [t0, t1] of [
    [0, 1],
    [1, 3],
    [-2, 2.5],
  ]) {
    const { table, degree } = values(hermiteBasis, { m, t0, t1 });
    expect(degree).toBe(2 * m + 1);
    (table as number[][][][]).forEach((ofEnd, i) => {
      ofEnd.forEach((row, k) => {
        row.forEach((atEnd, j) => {
          atEnd.forEach((value, r) => {
            expect(value).toBeCloseTo(i === j && k === r ? 1 : 0, 6);
          });
        });
      });
    });
  }
});

test("on an interval twice as long the tangent's polynomial is twice as high", () => {
  const value = (t1: number) => (values(hermiteBasis, { t0: 1, t1, u: 0.3 }).basis as number[][])[0]!;
  expect(value(3)[0]).toBeCloseTo(value(2)[0]!, 12);
  expect(value(3)[1]).toBeCloseTo(2 * value(2)[1]!, 12);
});

test("1/(1 + x²) at 15 nodes: 7.195 for the polynomial, 54.0 with slopes, 0.0016 in pieces", () => {
  const f = (x: number) => 1 / (1 + x * x);
  const nodes = evenly(-5, 5, 14);
  const points = nodes.map((x) => [f(x)]);
  const tangents = nodes.map((x) => [-2 * x * f(x) ** 2]);
  const worst = (p: (x: number) => number) =>
    Math.max(...evenly(-5, 5, 8000).map((x) => Math.abs(p(x) - f(x))));
  const polynomial = worst((x) =>
    lagrangeBasis(nodes, x).reduce((sum, weight, i) => sum + weight * points[i]![0]!, 0),
  );
  expect(polynomial).toBeCloseTo(7.195, 3);
  expect(worst((x) => hermitePolynomial(nodes, points, tangents).point(x)[0]!)).toBeCloseTo(54.0, 1);
  const spline = hermiteSpline(nodes, points, tangents);
  expect(worst((x) => spline.point(x)[0]!)).toBeCloseTo(0.0016, 4);
});
