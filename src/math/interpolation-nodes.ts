import { checkInteger } from "./check.ts";
import { checkOrdered } from "./check-ordered.ts";

/** The families of interpolation nodes: equidistant, the zeros of T_{n+1} and the extrema of T_n (Chebyshev). */
export const nodeKinds = ["equidistant", "chebyshev1", "chebyshev2"] as const;
export type NodeKind = (typeof nodeKinds)[number];

/**
 * The degree + 1 nodes of a family on [a, b], ascending and symmetric about the middle.
 *
 * `equidistant` and `chebyshev2` begin at a and end at b exactly. With degree 0 the one node is the middle, in any
 * family. Chebyshev nodes crowd towards the ends, which is what keeps the polynomial between them from oscillating.
 *
 * @throws RangeError if not a < b, if the degree is not a whole number ≥ 0 or for an unknown family.
 */
export function interpolationNodes(kind: NodeKind, a: number, b: number, degree: number): number[] {
  checkOrdered("a", a, "b", b);
  checkInteger("degree", degree, 0);
  const place = places[kind];
  if (!place) throw new RangeError(`kind: expected one of ${nodeKinds.join(", ")}, got "${kind}"`);
  return Array.from({ length: degree + 1 }, (_, k) => {
    const s = degree === 0 ? 0 : place(k, degree);
    return a * ((1 - s) / 2) + b * ((1 + s) / 2);
  });
}

/** The place of node k of n + 1 in [−1, 1]; a sine about the middle, not a cosine, keeps the nodes symmetric. */
const places: Readonly<Record<NodeKind, (k: number, n: number) => number>> = {
  equidistant: (k, n) => (2 * k - n) / n,
  chebyshev1: (k, n) => Math.sin((Math.PI * (2 * k - n)) / (2 * n + 2)),
  chebyshev2: (k, n) => Math.sin((Math.PI * (2 * k - n)) / (2 * n)),
};
