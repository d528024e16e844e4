import { expect, test } from "vitest";
import { endTangents } from "../../src/scene/end-tangents.ts";

const arrows = (points: number[][]) => endTangents(points).filter((mark) => mark.kind === "arrow");

test("the arrows are p′(0) and p′(1) in their true length", () => {
  const points = [
    [0, 0],
    [1, 2],
    [3, 2],
    [4, 1],
  ];
  expect(arrows(points).map(({ from, to }) => [from, to])).toEqual([
    [
      [0, 0],
      [3, 6],
    ],
    [
      [4, 1],
      [7, -2],
    ],
  ]);
});

test("where the derivative vanishes, a dashed line leads to the first point that differs", () => {
  const points = [
    [0, 0],
    [0, 0],
    [0, 0],
    [2, 1],
    [3, 3],
  ];
  const [first] = endTangents(points);
  expect(first).toMatchObject({
    kind: "path",
    role: "reference",
    steps: [
      ["M", [0, 0]],
      ["L", [2, 1]],
    ],
  });
  expect(arrows(points)).toHaveLength(1);
});

test("a curve that is one point has no tangent", () => {
  expect(
    endTangents([
      [1, 1],
      [1, 1],
    ]),
  ).toEqual([]);
});
