import { expect, test } from "vitest";
import { figureOf } from "../../src/demo/figure.ts";
import { withGuess } from "../../src/demo/guess.ts";
import { readQuery } from "../../src/demo/query.ts";
import { initialState } from "../../src/demo/state.ts";
import bezierCurve from "../../src/demos/bezier-curve.ts";

test("a guess is a point like others: handle, notation, no influence on what is computed", () => {
  const demo = withGuess(bezierCurve, "plane 0.3,2.8");
  const state = initialState(demo);
  expect(state.guess).toEqual([[0.3, 2.8]]);
  const figure = figureOf(demo, state);
  expect(figure.handles.map(({ id }) => id)).toContain("guess.0");
  expect(figure.values).toEqual(figureOf(bezierCurve, initialState(bezierCurve)).values);
  expect(readQuery(demo, "guess=1,2").patch).toEqual({ guess: [[1, 2]] });
});

test.each([null, "", "plane", "nowhere 1,2", "plane a,b"])("%s leaves the demo as it is", (text) => {
  expect(withGuess(bezierCurve, text)).toBe(bezierCurve);
});
