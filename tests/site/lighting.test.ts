import { expect, test } from "vitest";
import { meant, readTie } from "../../src/site/lighting.ts";

const ALL = [
  "points.0",
  "points.1",
  "points.10",
  "points.2",
  "weights.0",
  "b.1",
  "b.1.0",
  "b.1.1",
  "b.2.0",
  "p",
  "t",
];

test("a tie names a figure and something in it", () => {
  expect(readTie("fig-a/b.1.0")).toEqual({ figure: "fig-a", name: "b.1.0" });
});

test("a star means all of them, n the last, however many there are", () => {
  expect(meant("points.1", ALL)).toEqual(["points.1"]);
  expect(meant("points.*", ALL)).toEqual(["points.0", "points.1", "points.10", "points.2"]);
  expect(meant("points.n", ALL)).toEqual(["points.10"]);
  expect(meant("points.n-9", ALL)).toEqual(["points.1"]);
  expect(meant("b.*.0", ALL)).toEqual(["b.1.0", "b.2.0"]);
  expect(meant("b.*.*", ALL)).toEqual(["b.1.0", "b.1.1", "b.2.0"]);
  expect(meant("q.n", ALL)).toEqual([]);
  expect(meant("n", ALL)).toEqual(["n"]);
});
