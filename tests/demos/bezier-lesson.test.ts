import { expect, test } from "vitest";
import { glyphE } from "../../src/data/glyph-e.generated.ts";
import { outlineArcs } from "../../src/data/glyph-outline.ts";
import type { Demo } from "../../src/demo/index.ts";
import { initialState } from "../../src/demo/state.ts";
import bernsteinBasis from "../../src/demos/bernstein-basis.ts";
import bezierCurve from "../../src/demos/bezier-curve.ts";
import deCasteljau from "../../src/demos/de-casteljau.ts";
import glyph from "../../src/demos/glyph.ts";

// The numbers and claims of the lesson's text, read from the figures it talks about.

function values(demo: Demo, state: Record<string, unknown>) {
  return demo.values({ ...initialState(demo), ...state });
}

const zigzag = (middle: number) =>
  Array.from({ length: 11 }, (_, i) => [0.1 + 0.43 * i, i === 5 ? middle : i % 2 === 1 ? 2.9 : 0.2]);

test("the polynomial through the seven points has negative weights, and its sum is 1 all the same", () => {
  const points = [
    [0.1, 0.6],
    [0.7, 0.7],
    [1.2, 1.7],
    [2.2, 2],
    [3.2, 1.8],
    [3.7, 0.8],
    [4.4, 0.7],
  ];
  const { weights, sum, p } = values(bezierCurve, { points, t: 0.1, method: "interpolation" });
  expect((weights as number[]).filter((weight) => weight < 0)).toHaveLength(3);
  expect(sum).toBeCloseTo(1, 12);
  // It sags below every one of the points.
  expect((p as number[])[1]).toBeLessThan(0.6);
});

test("at ½ the weights are 1/4, 1/2, 1/4 and 1/8, 3/8, 3/8, 1/8", () => {
  const parabola = bezierCurve.states!.parabola!;
  expect(values(bezierCurve, { ...parabola, t: 0.5 }).weights).toEqual([0.25, 0.5, 0.25]);
  expect(values(bezierCurve, { t: 0.5 }).weights).toEqual([0.125, 0.375, 0.375, 0.125]);
});

test("lowering c₂ by 1.6 lowers p(½) from 1.91 to 1.31, by three eighths of the way", () => {
  const lowered = [
    [0, 0],
    [0.9, 2.3],
    [3.3, 1.1],
    [4.4, 0.3],
  ];
  const before = values(bezierCurve, { t: 0.5 }).p as number[];
  const after = values(bezierCurve, { t: 0.5, points: lowered }).p as number[];
  expect(before[1]).toBeCloseTo(1.9125, 12);
  expect(after[1]).toBeCloseTo(1.3125, 12);
  expect(after[0]).toBeCloseTo(before[0]!, 12);
});

test("of eleven points the fifth has less than a quarter; put down by 2.7 it lowers the curve by 0.66", () => {
  const high = values(bezierCurve, { points: zigzag(2.9), t: 0.5 });
  const low = values(bezierCurve, { points: zigzag(0.2), t: 0.5 });
  expect((high.weights as number[])[5]).toBeLessThan(0.25);
  expect(Math.max(...(high.weights as number[]))).toBe((high.weights as number[])[5]);
  expect((high.p as number[])[1]! - (low.p as number[])[1]!).toBeCloseTo(0.66, 2);
});

test("the cusp of the convex hull's figure is one: the derivative vanishes at ½", () => {
  const points = [
    [0.2, 0.3],
    [4.2, 2.9],
    [0.2, 2.9],
    [4.2, 0.3],
  ];
  const [b0, b1] = (values(deCasteljau, { points, t: 0.5 }).levels as number[][][])[2]!;
  expect(b0![0]).toBeCloseTo(b1![0]!, 12);
  expect(b0![1]).toBeCloseTo(b1![1]!, 12);
});

test("the worked example: triangle, point and derivative at ½, point at ¼", () => {
  const points = [
    [0, 0],
    [1, 2],
    [3, 2],
    [4, 0],
  ];
  const half = values(deCasteljau, { points, t: 0.5 });
  expect(half.levels).toEqual([
    points,
    [
      [0.5, 1],
      [2, 2],
      [3.5, 1],
    ],
    [
      [1.25, 1.5],
      [2.75, 1.5],
    ],
    [[2, 1.5]],
  ]);
  expect(half.left).toEqual([
    [0, 0],
    [0.5, 1],
    [1.25, 1.5],
    [2, 1.5],
  ]);
  expect(values(deCasteljau, { points, t: 0.25 }).p).toEqual([29 / 32, 9 / 8]);
  const { start, end } = values(bezierCurve, { points });
  expect([start, end]).toEqual([
    [3, 6],
    [3, -6],
  ]);
});

test("each Bernstein polynomial is largest at i/n, and the symmetry is what the mirror shows", () => {
  const at = (t: number) => values(bernsteinBasis, { t }).weights as number[];
  expect(at(0.3)[1]).toBeCloseTo(at(0.7)[2]!, 12);
  const { peak } = values(bernsteinBasis, { degree: 3, i: 1 });
  expect(peak).toBeCloseTo(4 / 9, 12);
});

test("the letter: 31 arcs, 4 of them straight, 17 points left out; a joint and a corner where the text has them", () => {
  const arcs = outlineArcs(glyphE).flat();
  expect(arcs).toHaveLength(31);
  expect(arcs.filter((arc) => arc.controlPoints.length === 2)).toHaveLength(4);
  const joints = arcs.length;
  expect(joints - glyphE.onCurve.filter(Boolean).length).toBe(17);
  // u = 2: the arcs before and behind share two stored points, so the point on the curve is left out.
  expect(arcs[1]!.from.filter((i) => arcs[2]!.from.includes(i))).toHaveLength(2);
  // u = 11: a point of the file, where the direction turns.
  expect(arcs[10]!.from.filter((i) => arcs[11]!.from.includes(i))).toHaveLength(1);
  expect(values(glyph, { u: 12.5 })).toMatchObject({ arc: 13, degree: 1, t: 0.5 });
});
