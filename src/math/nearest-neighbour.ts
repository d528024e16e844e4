import { checkNumber, checkNumbers, checkPoint, checkPoints } from "./check.ts";
import { distance, type Point } from "./point.ts";

/**
 * The index of the data position nearest to x; of equally near ones the lowest index.
 *
 * The positions need neither be sorted nor distinct; x may lie anywhere.
 *
 * @throws RangeError if there is no position or a number is not finite.
 */
export function nearestIndex1d(positions: readonly number[], x: number): number {
  checkNumbers("positions", positions);
  checkNumber("x", x);
  return lowestOf(positions.length, (i) => Math.abs(positions[i]! - x));
}

/**
 * The index of the data point nearest to a query point in Euclidean distance; of equally near ones the lowest index.
 *
 * Any dimension. The regions that share a nearest point are the Voronoi cells of the data.
 *
 * @throws RangeError if there is no point, dimensions differ or a number is not finite.
 */
export function nearestIndex(points: readonly Point[], query: Point): number {
  const dimension = checkPoints("points", points);
  checkPoint("query", query, dimension);
  return lowestOf(points.length, (i) => distance(points[i]!, query));
}

function lowestOf(count: number, measure: (i: number) => number): number {
  let best = 0;
  let least = measure(0);
  for (let i = 1; i < count; i++) {
    const value = measure(i);
    if (value < least) {
      best = i;
      least = value;
    }
  }
  return best;
}
