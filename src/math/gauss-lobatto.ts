/**
 * The nodes and weights of the Gauss–Lobatto rule with n points on [−1, 1], ends included, exact for polynomials up to
 * degree 2n − 3; n ≥ 2.
 *
 * The inner nodes are the zeros of P′_{n−1} (Legendre), by Newton's method from the extrema of a Chebyshev polynomial.
 */
export function gaussLobatto(n: number): { nodes: readonly number[]; weights: readonly number[] } {
  const nodes: number[] = [];
  const weights: number[] = [];
  for (let k = 0; k < n; k++) {
    let x = -Math.cos((Math.PI * k) / (n - 1));
    let value = 1;
    for (let step = 0; step < 10; step++) {
      // (j + 1) P_{j+1} = (2j + 1) x P_j − j P_{j−1}, up to P_{n−1}; the zeros of (1 − x²) P′_{n−1} include the ends.
      let before = 0;
      value = 1;
      for (let j = 0; j < n - 1; j++) {
        [before, value] = [value, ((2 * j + 1) * x * value - j * before) / (j + 1)];
      }
      x -= (x * value - before) / (n * value);
    }
    nodes.push(x);
    weights.push(2 / (n * (n - 1) * value * value));
  }
  return { nodes, weights };
}
