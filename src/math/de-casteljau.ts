import { checkNumber, checkPoints } from "./check.ts";
import { lerp, type Point } from "./point.ts";

/**
 * De Casteljau's construction: all levels of intermediate points at t.
 *
 * Level 0 is the control points; level r holds the n + 1 − r points b_i^r = (1 − t)·b_i^{r−1} + t·b_{i+1}^{r−1}; the
 * single point of level n is the curve point. Any finite t (outside [0, 1] the lines are continued), any degree
 * n ≥ 0, any dimension.
 *
 * @throws RangeError if there is no control point, dimensions differ or a number is not finite.
 */
export function deCasteljau(controlPoints: readonly Point[], t: number): Point[][] {
  checkPoints("controlPoints", controlPoints);
  checkNumber("t", t);
  const levels: Point[][] = [[...controlPoints]];
  for (let r = 1; r < controlPoints.length; r++) {
    const b = levels[r - 1]!;
    const level: Point[] = [];
    for (let i = 0; i + 1 < b.length; i++) {
      level.push(lerp(b[i]!, b[i + 1]!, t));
    }
    levels.push(level);
  }
  return levels;
}
