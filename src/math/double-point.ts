import { checkPoints } from "./check.ts";
import { add, angleBetween, cross2, dot, norm, type Point, scale } from "./point.ts";

/** The double point of a plane cubic. */
export type DoublePoint = {
  /**
   * `node`: the curve crosses itself; `cusp`: it turns back in a point where its derivative vanishes; `isolated`: the
   * two parameters are conjugate complex, the point lies apart from the curve; `none`.
   */
  readonly kind: "node" | "cusp" | "isolated" | "none";
  /** The real parameters, ascending: two of a node, one of a cusp. */
  readonly parameters: readonly number[];
  readonly point: Point | null;
  /** The derivatives at the two parameters of a node, and the angle between them (radians, 0 … π). */
  readonly tangents: readonly Point[];
  readonly angle: number | null;
};

/**
 * The double point of the plane curve p(t) = A·t³ + B·t² + C·t + D, `coefficients` [A, B, C, D], over all real t.
 *
 * p(s) = p(t) with s ≠ t means A·(σ² − π) + B·σ + C = 0 for the sum σ and the product π of the two parameters, a
 * linear system for σ and π. There is no double point if A and B are parallel: a graph over a line, a
 * parabola or a straight line. Decisions are made up to rounding (relative 1e-10).
 *
 * @throws RangeError if there are not four coefficients in the plane or a number is not finite.
 */
export function cubicDoublePoint(coefficients: readonly Point[]): DoublePoint {
  checkPoints("coefficients", coefficients, 4, 2);
  if (coefficients.length !== 4) {
    throw new RangeError(`coefficients: expected 4 points A, B, C, D, got ${coefficients.length}`);
  }
  const [a, b, c, d] = coefficients as readonly [Point, Point, Point, Point];
  const none: DoublePoint = { kind: "none", parameters: [], point: null, tangents: [], angle: null };
  const ab = cross2(a, b);
  if (Math.abs(ab) <= 1e-10 * norm(a) * norm(b)) return none;

  const sum = -cross2(a, c) / ab;
  const rest = add(scale(b, sum), c); // = −(σ² − π)·A
  const product = sum * sum + dot(rest, a) / dot(a, a);
  const point = add(
    scale(
      add(add(scale(a, sum ** 3 - 3 * sum * product), scale(b, sum * sum - 2 * product)), scale(c, sum)),
      1 / 2,
    ),
    d,
  );
  const discriminant = sum * sum - 4 * product;
  // The sizes of the terms that make up the discriminant, and so its rounding error.
  const size = sum * sum + (norm(b) * Math.abs(sum) + norm(c)) / norm(a) + ((norm(a) * norm(c)) / ab) ** 2;
  if (Math.abs(discriminant) <= 1e-10 * size) {
    return { ...none, kind: "cusp", parameters: [sum / 2], point };
  }
  if (discriminant < 0) return { ...none, kind: "isolated", point };
  const half = Math.sqrt(discriminant) / 2;
  const parameters = [sum / 2 - half, sum / 2 + half];
  const tangents = parameters.map((t) => add(add(scale(a, 3 * t * t), scale(b, 2 * t)), c));
  return { kind: "node", parameters, point, tangents, angle: angleBetween(tangents[0]!, tangents[1]!) };
}
