import { checkInterval, checkPoint, checkPositive } from "./check.ts";
import type { Curve } from "./curve.ts";
import { add, lerp, type Point, scale, sub, zero } from "./point.ts";
import type { Surface } from "./surface.ts";

/**
 * The explicit surface z = f(x, y) as a parametric one, S(x, y) = (x, y, f(x, y)).
 *
 * `f(x, y, k, l)` is the partial derivative of order k in x and l in y, finite on the domain. A graph has a normal
 * everywhere, (−f_x, −f_y, 1) normalized.
 *
 * @throws RangeError if an interval is empty.
 */
export function graphSurface(
  f: (x: number, y: number, k: number, l: number) => number,
  xInterval: readonly [number, number],
  yInterval: readonly [number, number],
): Surface {
  checkInterval("xInterval", xInterval);
  checkInterval("yInterval", yInterval);
  const partial = (x: number, y: number, k: number, l: number): Point => {
    const flat = k + l === 0 ? [x, y] : [k === 1 && l === 0 ? 1 : 0, k === 0 && l === 1 ? 1 : 0];
    return [...flat, f(x, y, k, l)];
  };
  return {
    dimension: 3,
    domain: [xInterval, yInterval],
    point: (x, y) => partial(x, y, 0, 0),
    partial,
  };
}

/** The k-th derivatives of cosine and sine at an angle. */
function circular(angle: number, k: number): [number, number] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const turned: [number, number][] = [
    [c, s],
    [-s, c],
    [-c, -s],
    [s, -c],
  ];
  return turned[k % 4]!;
}

/**
 * The sphere S(u, v) = centre + r·(cos u·cos v, sin u·cos v, sin v): u the longitude in [0, 2π], v the latitude in
 * [−π/2, π/2], radians. Implicitly ‖x − centre‖² = r².
 *
 * S_u × S_v points outwards. At the poles S_u = 0: an edge of the domain is collapsed there, though the sphere has a
 * tangent plane (see `limitNormal`).
 *
 * @throws RangeError unless the radius is positive and the centre a point in space.
 */
export function sphereSurface(radius = 1, centre: Point = [0, 0, 0]): Surface {
  checkPositive("radius", radius);
  checkPoint("centre", centre, 3);
  const partial = (u: number, v: number, k: number, l: number): Point => {
    const [cu, su] = circular(u, k);
    const [cv, sv] = circular(v, l);
    const direction = [cu * cv, su * cv, k === 0 ? sv : 0];
    return add(k + l === 0 ? centre : zero(3), scale(direction, radius));
  };
  return {
    dimension: 3,
    domain: [
      [0, 2 * Math.PI],
      [-Math.PI / 2, Math.PI / 2],
    ],
    point: (u, v) => partial(u, v, 0, 0),
    partial,
    speed: radius,
  };
}

/**
 * The surface of revolution of a plane curve (r(v), z(v)) about the z axis, S(u, v) = (r·cos u, r·sin u, z), u in
 * [0, 2π].
 *
 * Where the profile meets the axis, r = 0, S_u vanishes.
 *
 * @throws RangeError unless the profile is a curve in the plane.
 */
export function revolvedSurface(profile: Curve): Surface {
  checkDimension("profile", profile, 2);
  const partial = (u: number, v: number, k: number, l: number): Point => {
    const [r, z] = profile.derivative(v, l) as [number, number];
    const [c, s] = circular(u, k);
    return [r * c, r * s, k === 0 ? z : 0];
  };
  return {
    dimension: 3,
    domain: [[0, 2 * Math.PI], profile.domain],
    point: (u, v) => partial(u, v, 0, 0),
    partial,
  };
}

/**
 * The ruled surface of two curves over the same domain, S(u, v) = (1 − v)·a(u) + v·b(u), v in [0, 1]: a straight line
 * for every u.
 *
 * Its Gaussian curvature is nowhere positive. Where a(u) = b(u) the line is a point and S_v vanishes.
 *
 * @throws RangeError if the domains or the dimensions of the curves differ.
 */
export function ruledSurface(a: Curve, b: Curve): Surface {
  checkDimension("b", b, a.dimension);
  if (a.domain[0] !== b.domain[0] || a.domain[1] !== b.domain[1]) {
    throw new RangeError(`b.domain: expected [${a.domain}] as of a, got [${b.domain}]`);
  }
  const partial = (u: number, v: number, k: number, l: number): Point => {
    const [p, q] = [a.derivative(u, k), b.derivative(u, k)];
    if (l === 0) return lerp(p, q, v);
    return l === 1 ? sub(q, p) : zero(a.dimension);
  };
  return {
    dimension: a.dimension,
    domain: [a.domain, [0, 1]],
    point: (u, v) => partial(u, v, 0, 0),
    partial,
  };
}

function checkDimension(name: string, curve: Curve, dimension: number): void {
  if (curve.dimension !== dimension) {
    throw new RangeError(`${name}: expected a curve of dimension ${dimension}, got ${curve.dimension}`);
  }
}
