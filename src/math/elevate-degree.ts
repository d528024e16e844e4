import { checkInteger, checkPoints } from "./check.ts";
import { lerp, type Point } from "./point.ts";

/**
 * The control points of the same Bézier curve written with a degree higher by `times`.
 *
 * One step sets b_i' = i/(n+1) · b_{i−1} + (1 − i/(n+1)) · b_i for i = 0 … n + 1: corners are cut off the control
 * polygon, which comes closer to the curve.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or `times` is not a whole
 * number ≥ 0.
 */
export function elevateDegree(controlPoints: readonly Point[], times = 1): Point[] {
  checkPoints("controlPoints", controlPoints);
  checkInteger("times", times, 0);
  let b = [...controlPoints];
  for (let k = 0; k < times; k++) {
    const n = b.length - 1;
    const inner = b.slice(1).map((point, i) => lerp(point, b[i]!, (i + 1) / (n + 1)));
    b = [b[0]!, ...inner, b[n]!];
  }
  return b;
}
