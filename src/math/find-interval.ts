/**
 * The index i of the interval [nodes[i], nodes[i+1]) that holds t, by bisection; the last interval is closed.
 *
 * `nodes` ascending, at least two; t before the first node gives 0, t after the last one the last interval.
 */
export function findInterval(nodes: ArrayLike<number>, t: number): number {
  let low = 0;
  let high = nodes.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (t >= nodes[middle]!) low = middle;
    else high = middle;
  }
  return low;
}
