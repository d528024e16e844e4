import { checkNumber, checkPoints } from "./check.ts";
import { checkCurveKnots, findSpan } from "./knots.ts";
import { lerp, type Point } from "./point.ts";

/** De Boor's scheme at one parameter. */
export type DeBoor = {
  /** The span k with u_k ≤ t < u_{k+1} (see `findSpan`). */
  readonly span: number;
  /** Level 0 is d_{k−p} … d_k, the control points that act; the single point of level p is the curve point. */
  readonly levels: Point[][];
};

/**
 * De Boor's algorithm: all levels of intermediate points at t.
 *
 * d_i^r = (1 − a)·d_{i−1}^{r−1} + a·d_i^{r−1} with a = (t − u_i)/(u_{i+p−r+1} − u_i). It is de Casteljau's triangle with
 * another interval in each entry; with knots 0 … 0, 1 … 1 it is de Casteljau's. Outside the domain the end polynomials
 * are continued.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite or for bad knots (see
 * `checkCurveKnots`).
 */
export function deBoor(
  degree: number,
  knots: readonly number[],
  controlPoints: readonly Point[],
  t: number,
): DeBoor {
  checkPoints("controlPoints", controlPoints);
  checkCurveKnots(degree, knots, controlPoints.length);
  checkNumber("t", t);
  return deBoorScheme(degree, knots, controlPoints, t);
}

/** The same for data that have been checked. */
export function deBoorScheme(
  degree: number,
  knots: readonly number[],
  controlPoints: readonly Point[],
  t: number,
): DeBoor {
  const span = findSpan(degree, knots, t);
  const first = span - degree;
  const levels: Point[][] = [controlPoints.slice(first, span + 1)];
  for (let r = 1; r <= degree; r++) {
    const d = levels[r - 1]!;
    const level: Point[] = [];
    for (let j = 0; j + 1 < d.length; j++) {
      const i = first + r + j;
      const share = (t - knots[i]!) / (knots[i + degree - r + 1]! - knots[i]!);
      level.push(lerp(d[j]!, d[j + 1]!, share));
    }
    levels.push(level);
  }
  return { span, levels };
}
