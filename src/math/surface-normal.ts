import { binomial } from "./bernstein.ts";
import { add, cross, norm, normalize, type Point, scale } from "./point.ts";
import type { Surface } from "./surface.ts";
import { relativeZero } from "./tangent.ts";

/**
 * The unit normal (S_u × S_v)/‖S_u × S_v‖ of a surface in space, or `null` where the product vanishes.
 *
 * "Vanishes" is up to rounding: a tangent shorter than 1e-10 of the longest one on the surface, or tangents whose angle
 * has a sine below 1e-10. There the surface may still have a tangent plane (see `limitNormal`).
 */
export function surfaceNormal(surface: Surface, u: number, v: number): Point | null {
  const su = surface.partial(u, v, 1, 0);
  const sv = surface.partial(u, v, 0, 1);
  const zero = zeroLength(surface, u, v, su, sv);
  if (norm(su) <= zero || norm(sv) <= zero) return null;
  const product = cross(normalize(su)!, normalize(sv)!);
  return norm(product) <= relativeZero ? null : normalize(product);
}

/**
 * The unit normal or, on an edge that is collapsed to a point, its limit across the edge along the iso-parametric line;
 * `null` if there is none.
 *
 * On a collapsed edge u = a the derivative S_v is zero all along and S_u × S_v vanishes; the limit has the direction of
 * its first derivative in u that does not. Different lines into one point may have different limits: then the surface
 * has a tip there and no tangent plane. Looked for up to order 7.
 */
export function limitNormal(surface: Surface, u: number, v: number): Point | null {
  const normal = surfaceNormal(surface, u, v);
  if (normal) return normal;
  const [[u0, u1], [v0, v1]] = surface.domain;
  // Where two collapsed edges meet, neither has a limit: along each of them nothing moves.
  if ((u === u0 || u === u1) && isCollapsed(surface, "u", u)) {
    return limitAcross(surface, u, v, "u", u === u1 ? -1 : 1);
  }
  if ((v === v0 || v === v1) && isCollapsed(surface, "v", v)) {
    return limitAcross(surface, u, v, "v", v === v1 ? -1 : 1);
  }
  return null;
}

/**
 * Whether the edge on which one parameter keeps a value is a single point: the derivative along it is zero, up to
 * rounding, at 33 parameters (which is proof for polynomials of degree up to 33).
 */
export function isCollapsed(surface: Surface, fixed: "u" | "v", value: number): boolean {
  const [a, b] = surface.domain[fixed === "u" ? 1 : 0];
  for (let k = 0; k <= 32; k++) {
    const t = a + ((b - a) * k) / 32;
    const [u, v] = fixed === "u" ? [value, t] : [t, value];
    const along = fixed === "u" ? surface.partial(u, v, 0, 1) : surface.partial(u, v, 1, 0);
    const across = fixed === "u" ? surface.partial(u, v, 1, 0) : surface.partial(u, v, 0, 1);
    if (norm(along) > zeroLength(surface, u, v, along, across)) return false;
  }
  return true;
}

/** The direction of the first derivative of S_u × S_v across an edge that does not vanish. */
function limitAcross(
  surface: Surface,
  u: number,
  v: number,
  across: "u" | "v",
  inward: 1 | -1,
): Point | null {
  const partial = (k: number, l: number) =>
    across === "u" ? surface.partial(u, v, k, l) : surface.partial(u, v, l, k);
  // With respect to the other parameter the product changes its sign: S_v × S_u = −S_u × S_v.
  const order = across === "u" ? 1 : -1;
  for (let r = 1; r <= 7; r++) {
    // Leibniz' rule for the r-th derivative of a × b, a the derivative across and b the one along the edge. The last
    // summand is missing, since b itself is zero there.
    let product: Point = [0, 0, 0];
    let size = 0;
    for (let i = 0; i < r; i++) {
      const a = partial(i + 1, 0);
      const b = partial(r - i, 1);
      product = add(product, scale(cross(a, b), binomial(r, i)));
      size = Math.max(size, binomial(r, i) * norm(a) * norm(b));
    }
    const speed = surface.speed ?? 0;
    if (norm(product) > relativeZero * Math.max(size, speed * speed)) {
      return normalize(scale(product, order * inward ** r));
    }
  }
  return null;
}

/** The length below which a tangent counts as zero; where no bound is known, measured by the derivatives at hand. */
function zeroLength(surface: Surface, u: number, v: number, su: Point, sv: Point): number {
  const largest = surface.speed ?? Math.max(norm(su), norm(sv), norm(surface.partial(u, v, 1, 1)));
  return relativeZero * largest;
}
