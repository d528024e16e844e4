import { bezierDerivative, bezierPoint } from "../math/index.ts";
import { bezierSteps } from "./bezier-steps.ts";
import { evenly, hermiteSteps } from "./hermite-steps.ts";
import type { PathStep, XY } from "./marks.ts";

/**
 * The graph of Σ coefficients[i] · B_i^n(t) over [0, 1].
 *
 * It is itself a Bézier curve, with control points (i/n, coefficients[i]): drawn exactly up to degree 3, above in
 * cubic pieces with the graph's own values and slopes.
 */
export function bernsteinGraph(coefficients: readonly number[]): PathStep[] {
  const n = coefficients.length - 1;
  if (n <= 3) return bezierSteps(coefficients.map((c, i): XY => [n === 0 ? 0.5 : i / n, c]));
  const points = coefficients.map((c) => [c]);
  return hermiteSteps(
    (t) => [t, bezierPoint(points, t)[0]!],
    (t) => [1, bezierDerivative(points, t)[0]!],
    evenly(0, 1, 3 * n),
  );
}

/** The region between two graphs of the same degree ≥ 1, the first below the second. */
export function bernsteinBand(low: readonly number[], high: readonly number[]): PathStep[] {
  const back = reversed(bernsteinGraph(low));
  return [...bernsteinGraph(high), ["L", back[0]![1]!], ...back.slice(1), ["Z"]];
}

/** The same open path from its end to its start. */
function reversed(steps: readonly PathStep[]): PathStep[] {
  const ends = steps.map((step) => step.at(-1) as XY);
  const back: PathStep[] = [["M", ends.at(-1)!]];
  for (let k = steps.length - 1; k > 0; k--) {
    const step = steps[k]!;
    const to = ends[k - 1]!;
    if (step[0] === "C") back.push(["C", step[2], step[1], to]);
    else if (step[0] === "Q") back.push(["Q", step[1], to]);
    else back.push(["L", to]);
  }
  return back;
}
