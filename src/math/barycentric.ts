import { checkDistinct } from "./check.ts";

/**
 * The barycentric weights w_i = 1/Π_{j≠i} (t_i − t_j) of interpolation nodes, in the order of the nodes.
 *
 * They depend on the nodes alone: moving a data point costs nothing, a new node costs one pass. With them
 * L_i(t) = l(t)·w_i/(t − t_i), l(t) = Π (t − t_j).
 *
 * @throws RangeError if there is no node, two nodes are equal, a number is not finite, or there are so many nodes that
 * a weight leaves the range of doubles.
 */
export function barycentricWeights(nodes: readonly number[]): number[] {
  checkDistinct("nodes", nodes);
  return weightsInUnit(nodes, 1);
}

/** The weights divided by the largest modulus among them; only their ratios matter for the quotient form. */
export function normalizeWeights(weights: readonly number[]): number[] {
  const largest = weights.reduce((max, w) => Math.max(max, Math.abs(w)), 0);
  return weights.map((w) => w / largest);
}

/**
 * The weights for nodes measured in a unit of length. A quarter of the interval as unit keeps them near 1 (the
 * capacity of an interval is a quarter of its length).
 */
export function weightsInUnit(nodes: readonly number[], unit: number): number[] {
  const weights = nodes.map((ti, i) => {
    let product = 1;
    nodes.forEach((tj, j) => {
      if (j !== i) product *= (ti - tj) / unit;
    });
    return 1 / product;
  });
  const bad = weights.findIndex((w) => !Number.isFinite(w) || w === 0);
  if (bad >= 0) {
    throw new RangeError(
      `nodes: expected barycentric weights within the range of doubles, got ${weights[bad]} at index ${bad}; take fewer nodes or Chebyshev nodes`,
    );
  }
  return weights;
}

/**
 * The products l(t)/(t − t_i) = Π_{j≠i} (t − t_j)/unit for all i: those before i times those after i, in linear time.
 *
 * No division by t − t_i takes place, so nothing special happens at a node.
 */
export function nodeProducts(nodes: readonly number[], t: number, unit: number): number[] {
  const products = new Array<number>(nodes.length).fill(1);
  for (let i = 1, before = 1; i < nodes.length; i++) {
    before *= (t - nodes[i - 1]!) / unit;
    products[i] = before;
  }
  for (let i = nodes.length - 2, after = 1; i >= 0; i--) {
    after *= (t - nodes[i + 1]!) / unit;
    products[i] = products[i]! * after;
  }
  return products;
}
