import { checkDistinct, checkInteger, checkNumber } from "./check.ts";

/**
 * The Lagrange polynomials L_0 … L_n of n + 1 nodes at t: L_i(t) = Π_{j≠i} (t − t_j)/(t_i − t_j).
 *
 * L_i is 1 at its own node and 0 at all others, exactly; the values add up to 1. The nodes need not be sorted; any
 * finite t.
 *
 * @throws RangeError if there is no node, two nodes are equal or a number is not finite.
 */
export function lagrangeBasis(nodes: readonly number[], t: number): number[] {
  checkDistinct("nodes", nodes);
  checkNumber("t", t);
  return nodes.map((ti, i) => {
    let product = 1;
    nodes.forEach((tj, j) => {
      if (j !== i) product *= (t - tj) / (ti - tj);
    });
    return product;
  });
}

/**
 * The r-th derivatives of the Lagrange polynomials at t.
 *
 * @throws RangeError as `lagrangeBasis`, and if r is not a whole number ≥ 0.
 */
export function lagrangeBasisDerivative(nodes: readonly number[], t: number, r = 1): number[] {
  checkDistinct("nodes", nodes);
  checkNumber("t", t);
  checkInteger("r", r, 0);
  return lagrangeDerivatives(nodes, t, r).map((derivatives) => derivatives[r]!);
}

/**
 * The derivatives of order 0 … r of every Lagrange polynomial at t, `[i][k]`; for nodes that have been checked.
 *
 * Each product is multiplied out as a Taylor polynomial about t, cut off after the power r: the factor
 * (t + ε − t_j)/(t_i − t_j) turns a coefficient c_k into c_k·(t − t_j)/(t_i − t_j) + c_{k−1}/(t_i − t_j).
 */
export function lagrangeDerivatives(nodes: readonly number[], t: number, r: number): number[][] {
  return nodes.map((ti, i) => {
    const c = [1, ...new Array<number>(r).fill(0)];
    nodes.forEach((tj, j) => {
      if (j === i) return;
      for (let k = r; k > 0; k--) c[k] = c[k]! * ((t - tj) / (ti - tj)) + c[k - 1]! / (ti - tj);
      c[0] = c[0]! * ((t - tj) / (ti - tj));
    });
    let factorial = 1;
    return c.map((coefficient, k) => {
      factorial *= k || 1;
      return factorial * coefficient;
    });
  });
}
