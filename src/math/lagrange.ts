import { nodeProducts, weightsInUnit } from "./barycentric.ts";
import {
  checkDistinct,
  checkInteger,
  checkNumber,
  checkNumbers,
  checkPoints,
  checkSameLength,
} from "./check.ts";
import type { Curve } from "./curve.ts";
import { lagrangeDerivatives } from "./lagrange-basis.ts";
import { combine, type Point } from "./point.ts";

/**
 * The curve Σ P_i · L_i(t) through points P_i at nodes t_i: the only polynomial of degree ≤ n that does it.
 *
 * Evaluated in the first barycentric form l(t) · Σ w_i/(t − t_i) · P_i, which is backward stable and, unlike the
 * quotient form, does not suffer from the Lebesgue constant of the nodes (N. J. Higham, The numerical stability of
 * barycentric Lagrange interpolation). At a node it returns the data point itself. The nodes need not be sorted; the
 * points may coincide. The domain is the interval of the nodes ([t_0, t_0 + 1] for a single one); outside it the
 * polynomial is continued.
 *
 * @throws RangeError if there is no node, two nodes are equal, the lists do not fit, dimensions differ, a number is not
 * finite or there are too many nodes for doubles (about a thousand equidistant ones).
 */
export function lagrangeCurve(nodes: readonly number[], points: readonly Point[]): Curve {
  const dimension = checkPoints("points", points);
  const evaluate = interpolant(nodes, points);
  const a = nodes.reduce((low, t) => Math.min(low, t));
  const b = nodes.reduce((high, t) => Math.max(high, t));
  const domain = [a, b > a ? b : a + 1] as const;
  return onDomain({ dimension, domain, point: (t) => evaluate(t), derivative: (t, r = 1) => evaluate(t, r) });
}

/**
 * The interpolating polynomial through numbers: a function (t, r = 0) → its r-th derivative at t.
 *
 * @throws RangeError as `lagrangeCurve`.
 */
export function lagrangeFunction(
  nodes: readonly number[],
  values: readonly number[],
): (t: number, r?: number) => number {
  checkNumbers("values", values);
  const points = values.map((value) => [value]);
  const evaluate = interpolant(nodes, points);
  return (t, r = 0) => evaluate(t, r)[0]!;
}

/**
 * The point at t of the interpolating polynomial, or its r-th derivative. For many parameters of one polynomial make a
 * `lagrangeCurve` once.
 *
 * @throws RangeError as `lagrangeCurve`, and if t is not finite or r not a whole number ≥ 0.
 */
export function lagrangePoint(nodes: readonly number[], points: readonly Point[], t: number, r = 0): Point {
  checkPoints("points", points);
  checkNumber("t", t);
  checkInteger("r", r, 0);
  return interpolant(nodes, points)(t, r);
}

function interpolant(nodes: readonly number[], points: readonly Point[]): (t: number, r?: number) => Point {
  checkDistinct("nodes", nodes);
  checkSameLength("points", points, "nodes", nodes);
  const width = nodes.reduce((high, t) => Math.max(high, t)) - nodes.reduce((low, t) => Math.min(low, t));
  const unit = width > 0 ? width / 4 : 1;
  const weights = weightsInUnit(nodes, unit);
  return (t, r = 0) => {
    if (r > 0) {
      const weights = lagrangeDerivatives(nodes, t, r).map((derivatives) => derivatives[r]!);
      return combine(weights, points);
    }
    const hit = nodes.indexOf(t);
    if (hit >= 0) return points[hit]!;
    const products = nodeProducts(nodes, t, unit);
    const basis = products.map((product, i) => product * weights[i]!);
    return combine(basis, points);
  };
}

/** A curve of one polynomial splits by restricting its domain. */
export function onDomain(curve: Curve): Curve {
  const [a, b] = curve.domain;
  return {
    ...curve,
    split: (t) => [onDomain({ ...curve, domain: [a, t] }), onDomain({ ...curve, domain: [t, b] })],
  };
}
