import type { Curve } from "./curve.ts";
import type { Point } from "./point.ts";

/**
 * A parametric surface [a, b] × [c, d] → ℝ³ (or any ℝᵈ where no normal is asked for).
 *
 * A value of this type is valid: its builder has checked the data. Its functions accept finite parameters (outside the
 * domain the formula is continued) and return finite coordinates.
 */
export type Surface = {
  readonly dimension: number;
  /** The intervals of u and of v. */
  readonly domain: readonly [readonly [number, number], readonly [number, number]];
  /** The surface point S(u, v). */
  readonly point: (u: number, v: number) => Point;
  /** The partial derivative of order k in u and l in v; k = l = 0 is the point. */
  readonly partial: (u: number, v: number, k: number, l: number) => Point;
  /** A bound for the lengths of S_u and S_v on the domain; a derivative is zero if tiny beside it. */
  readonly speed?: number;
};

/**
 * The iso-parametric curve of a surface: u (or v) keeps a value, the other parameter runs.
 *
 * The value may lie outside the domain, where the surface is continued.
 */
export function isoCurve(surface: Surface, fixed: "u" | "v", value: number): Curve {
  const { dimension, domain, partial } = surface;
  const derivative = (t: number, r = 1): Point =>
    fixed === "u" ? partial(value, t, 0, r) : partial(t, value, r, 0);
  return {
    dimension,
    domain: domain[fixed === "u" ? 1 : 0],
    point: (t) => derivative(t, 0),
    derivative,
  };
}
