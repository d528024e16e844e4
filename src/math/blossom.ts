import { checkNumbers, checkPoints } from "./check.ts";
import { lerp, type Point } from "./point.ts";

/**
 * The blossom (polar form) b[t_1, …, t_n] of a Bézier curve of degree n: de Casteljau's construction with a
 * parameter of its own for each level.
 *
 * It is symmetric, affine in each argument, and b[t, …, t] = p(t); the control points are b_i = b[0, …, 0, 1, …, 1]
 * with i ones.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or the number of
 * parameters is not the degree.
 */
export function blossom(controlPoints: readonly Point[], ts: readonly number[]): Point {
  checkPoints("controlPoints", controlPoints);
  checkNumbers("ts", ts, 0);
  const n = controlPoints.length - 1;
  if (ts.length !== n)
    throw new RangeError(`ts: expected ${n} parameters, one for each degree, got ${ts.length}`);
  let b = [...controlPoints];
  for (const t of ts) {
    b = b.slice(1).map((next, i) => lerp(b[i]!, next, t));
  }
  return b[0]!;
}
