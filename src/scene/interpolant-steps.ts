import { lagrangeCurve } from "../math/index.ts";
import { evenly, hermiteSteps } from "./hermite-steps.ts";
import type { PathStep, XY } from "./marks.ts";

/** The drawing of the polynomial curve through two or more points at the nodes i/n. */
export function interpolantSteps(points: readonly XY[]): PathStep[] {
  const n = points.length - 1;
  const curve = lagrangeCurve(evenly(0, 1, n), points);
  return hermiteSteps(curve.point, curve.derivative, evenly(0, 1, n <= 3 ? 1 : 8 * n));
}
