import { checkInteger, checkPoints } from "./check.ts";
import { elevateDegree } from "./elevate-degree.ts";
import { distance, lerp, type Point } from "./point.ts";

/** A Bézier curve of lower degree and how far it may be from the original one. */
export type Reduced = {
  readonly controlPoints: readonly Point[];
  /** A bound for ‖p(t) − q(t)‖ on [0, 1]: the largest distance of control points at equal degree. */
  readonly error: number;
};

/**
 * A Bézier curve q of a degree lower by `times`, close to the given curve p and with the same end points.
 *
 * Each step undoes an elevation, from the left for the first half of the control points and from the right for the
 * second; an odd degree leaves a middle point, the mean of both ways. It gives the curve back if it had been elevated.
 *
 * Source: A. R. Forrest, Interactive interpolation and approximation by Bézier polynomials.
 *
 * @throws RangeError if there is no control point, dimensions differ, a number is not finite, or `times` is not a whole
 * number from 0 to n − 1 (0 for degree 0): a line through two ends is the least that keeps them.
 */
export function reduceDegree(controlPoints: readonly Point[], times = 1): Reduced {
  checkPoints("controlPoints", controlPoints);
  checkInteger("times", times, 0, Math.max(0, controlPoints.length - 2));
  let reduced: readonly Point[] = controlPoints;
  for (let k = 0; k < times; k++) reduced = reduceOnce(reduced);
  const elevated = elevateDegree(reduced, times);
  return {
    controlPoints: reduced,
    error: Math.max(...controlPoints.map((p, i) => distance(p, elevated[i]!))),
  };
}

/** Solves n·b_i = i·q_{i−1} + (n − i)·q_i for the q_i, upwards from q_0 = b_0 and downwards from q_{n−1} = b_n. */
function reduceOnce(b: readonly Point[]): Point[] {
  const n = b.length - 1;
  const upwards: Point[] = [b[0]!];
  for (let i = 1; i < n; i++) upwards.push(lerp(upwards[i - 1]!, b[i]!, n / (n - i)));
  const downwards: Point[] = new Array<Point>(n).fill(b[n]!);
  for (let i = n - 1; i > 0; i--) downwards[i - 1] = lerp(downwards[i]!, b[i]!, n / i);
  const middle = (n - 1) / 2;
  return upwards.map((q, i) => {
    if (i === middle) return lerp(q, downwards[i]!, 0.5);
    return i < middle ? q : downwards[i]!;
  });
}
