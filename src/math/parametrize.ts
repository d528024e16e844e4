import { checkNumber, checkPoints } from "./check.ts";
import { distance, type Point } from "./point.ts";

/** The exponents of the three usual parametrisations: nodes from points. */
export const parametrizations = { uniform: 0, centripetal: 0.5, chordal: 1 } as const;

/**
 * Nodes for points: t_0 = 0, t_{i+1} = t_i + |P_{i+1} − P_i|^alpha.
 *
 * alpha = 0 gives 0, 1, 2, … (uniform), 1 the lengths of the polygon (chordal), ½ the square roots of its legs
 * (centripetal); anything between is allowed.
 *
 * @throws RangeError if alpha is not in [0, 1], dimensions differ, a number is not finite, or, for alpha > 0, if two
 * neighbouring points coincide (or are so close that their nodes do).
 */
export function parametrize(points: readonly Point[], alpha: number): number[] {
  checkPoints("points", points);
  checkNumber("alpha", alpha);
  if (alpha < 0 || alpha > 1) throw new RangeError(`alpha: expected a number from 0 to 1, got ${alpha}`);
  const nodes = [0];
  for (let i = 1; i < points.length; i++) {
    const next = nodes[i - 1]! + distance(points[i - 1]!, points[i]!) ** alpha;
    if (!(next > nodes[i - 1]!)) {
      throw new RangeError(
        `points[${i}]: expected a point apart from points[${i - 1}], got [${points[i]}]; only the uniform parametrisation allows both at one place`,
      );
    }
    nodes.push(next);
  }
  return nodes;
}
