import { checkDistinct, checkNumber, checkPoints, checkSameLength } from "./check.ts";
import { lerp, type Point } from "./point.ts";

/**
 * Neville's scheme: all levels of repeated linear interpolation at t.
 *
 * Level 0 is the data points; entry i of level r is the value at t of the polynomial through the points i … i + r,
 * p_i^r = ((t_{i+r} − t)·p_i^{r−1} + (t − t_i)·p_{i+1}^{r−1})/(t_{i+r} − t_i). The single point of the last level is
 * the interpolated one. It is de Casteljau's triangle with another interval in each entry. The nodes need not be
 * sorted; any finite t.
 *
 * @throws RangeError if there is no node, two nodes are equal, the lists do not fit or a number is not finite.
 */
export function neville(nodes: readonly number[], points: readonly Point[], t: number): Point[][] {
  checkDistinct("nodes", nodes);
  checkPoints("points", points);
  checkSameLength("points", points, "nodes", nodes);
  checkNumber("t", t);
  const levels: Point[][] = [[...points]];
  for (let r = 1; r < points.length; r++) {
    const p = levels[r - 1]!;
    const level: Point[] = [];
    for (let i = 0; i + 1 < p.length; i++) {
      const share = (t - nodes[i]!) / (nodes[i + r]! - nodes[i]!);
      level.push(lerp(p[i]!, p[i + 1]!, share));
    }
    levels.push(level);
  }
  return levels;
}
