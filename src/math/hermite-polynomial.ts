import { binomial } from "./bernstein.ts";
import { checkDistinct, checkPoints, checkSameLength } from "./check.ts";
import type { Curve } from "./curve.ts";
import { onDomain } from "./lagrange.ts";
import { lagrangeDerivatives } from "./lagrange-basis.ts";
import { add, combine, type Point } from "./point.ts";

/**
 * The one polynomial of degree ≤ 2n + 1 with given points and tangents (first derivatives) at n + 1 nodes.
 *
 * p(t) = Σ P_i·[1 − 2(t − t_i)·L_i′(t_i)]·L_i(t)² + Σ m_i·(t − t_i)·L_i(t)². Global, and with many equidistant nodes it
 * oscillates more than the polynomial without tangents: what cures is the division into segments (`hermiteSpline`).
 * The nodes need not be sorted. The domain is the interval of the nodes.
 *
 * @throws RangeError if there are fewer than two nodes, two nodes are equal, the lists do not fit, dimensions differ or a
 * number is not finite.
 */
export function hermitePolynomial(
  nodes: readonly number[],
  points: readonly Point[],
  tangents: readonly Point[],
): Curve {
  checkDistinct("nodes", nodes, 2);
  const dimension = checkPoints("points", points);
  checkPoints("tangents", tangents, 1, dimension);
  checkSameLength("points", points, "nodes", nodes);
  checkSameLength("tangents", tangents, "nodes", nodes);
  const slopes = nodes.map((ti, i) => nodes.reduce((sum, tj, j) => (j === i ? sum : sum + 1 / (ti - tj)), 0));
  const derivative = (t: number, r = 1): Point => {
    // Per node the derivatives of order r and r − 1 of L_i², then those of its products with linear functions.
    const squares = lagrangeDerivatives(nodes, t, r).map(
      (l) => [square(l, r), r * square(l, r - 1)] as const,
    );
    const ofTangents = squares.map(([high, low], i) => (t - nodes[i]!) * high + low);
    const ofPoints = squares.map(([high], i) => high - 2 * slopes[i]! * ofTangents[i]!);
    return add(combine(ofPoints, points), combine(ofTangents, tangents));
  };
  const domain = [Math.min(...nodes), Math.max(...nodes)] as const;
  return onDomain({ dimension, domain, point: (t) => derivative(t, 0), derivative });
}

/** The r-th derivative of a square by Leibniz' rule, from the derivatives of the function; 0 for r < 0. */
function square(l: readonly number[], r: number): number {
  let sum = 0;
  for (let k = 0; k <= r; k++) sum += binomial(r, k) * l[k]! * l[r - k]!;
  return sum;
}
