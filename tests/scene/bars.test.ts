import { expect, test } from "vitest";
import { barView, weightBar } from "../../src/scene/bars.ts";
import { wording } from "../../src/scene/label.ts";
import type { PathMark } from "../../src/scene/marks.ts";
import { same } from "../../src/words/words.ts";

const number = (weight: number) => wording(same(String(weight)));
const pieces = (weights: readonly number[]) =>
  weightBar(weights, number).filter((mark): mark is PathMark => mark.kind === "path");
const ends = ({ steps }: PathMark) => {
  const xs = steps.flatMap((step) => (step[0] === "Z" ? [] : [step[1][0]!]));
  return [Math.min(...xs), Math.max(...xs)] as const;
};

test("the length of a piece is its weight, up to the gap", () => {
  const weights = [0.216, 0.432, 0.288, 0.064];
  pieces(weights).forEach((piece, i) => {
    const [left, right] = ends(piece);
    expect(Math.abs(right - left - weights[i]!)).toBeLessThanOrEqual(0.003 + 1e-12);
  });
  expect(ends(pieces(weights)[0]!)[0]).toBe(0);
  expect(ends(pieces(weights).at(-1)!)[1]).toBeCloseTo(1, 12);
});

test("negative weights are hollow and take the room of their modulus", () => {
  const [first, second] = pieces([1.5, -0.5]);
  expect([first!.paint, second!.paint]).toEqual(["fill", undefined]);
  expect(ends(second!)[1] - ends(second!)[0]).toBeCloseTo(0.25, 2);
});

test("a weight of nothing has no piece; all weight on one point fills the bar", () => {
  expect(pieces([0, 1, 0]).map((piece) => piece.index)).toEqual([1]);
  expect(ends(pieces([0, 1, 0])[0]!)).toEqual([0, 1]);
});

test("pieces long enough carry their number, short ones do not", () => {
  const labels = weightBar([0.9, 0.1], number).filter((mark) => mark.kind === "label");
  expect(labels.map((mark) => mark.index)).toEqual([0]);
});

test("the bar's window is as wide as the figure", () => {
  expect(barView({ label: same("bar") })).toMatchObject({ x: [0, 1], y: [0, 1], fit: "stretch" });
});
