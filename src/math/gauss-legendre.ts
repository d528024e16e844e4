/**
 * The nodes and weights of the Gauss–Legendre rule with n points on [−1, 1], exact for polynomials up to degree
 * 2n − 1; n ≥ 1.
 *
 * The nodes are the zeros of the Legendre polynomial P_n, by Newton's method from a well-known first guess.
 */
export function gaussLegendre(n: number): { nodes: readonly number[]; weights: readonly number[] } {
  const nodes: number[] = [];
  const weights: number[] = [];
  for (let k = 0; k < n; k++) {
    let x = -Math.cos((Math.PI * (k + 0.75)) / (n + 0.5));
    let slope = 1;
    for (let step = 0; step < 6; step++) {
      // (j + 1) P_{j+1} = (2j + 1) x P_j − j P_{j−1}, and (x² − 1) P_n′ = n (x P_n − P_{n−1}).
      let [before, p] = [0, 1];
      for (let j = 0; j < n; j++) [before, p] = [p, ((2 * j + 1) * x * p - j * before) / (j + 1)];
      slope = (n * (x * p - before)) / (x * x - 1);
      x -= p / slope;
    }
    nodes.push(x);
    weights.push(2 / ((1 - x * x) * slope * slope));
  }
  return { nodes, weights };
}
