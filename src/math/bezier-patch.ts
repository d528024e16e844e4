import { bezierDerivative, bezierPoint } from "./bezier.ts";
import { checkInteger, checkNumber, checkPoints } from "./check.ts";
import { distance, type Point } from "./point.ts";
import type { Surface } from "./surface.ts";

/** A control net: `net[i][j]`, i running with u (degree rows − 1), j with v (degree columns − 1). */
export type ControlNet = readonly (readonly Point[])[];

/**
 * Demands a net of at least one row and column, all rows equally long, of finite points of one dimension.
 *
 * @returns the dimension.
 * @throws RangeError naming the row or point that is not as it should be.
 */
export function checkNet(name: string, net: ControlNet): number {
  if (!Array.isArray(net) || net.length === 0)
    throw new RangeError(`${name}: expected at least 1 row, got none`);
  let dimension: number | undefined;
  net.forEach((row, i) => {
    dimension = checkPoints(`${name}[${i}]`, row, 1, dimension);
    if (row.length !== net[0]!.length) {
      throw new RangeError(
        `${name}[${i}]: expected ${net[0]!.length} points as in the first row, got ${row.length}`,
      );
    }
  });
  return dimension!;
}

/**
 * The point S(u, v) = Σ_i Σ_j c_ij · B_i^m(u) · B_j^n(v) of a Bézier patch: a Bézier curve of Bézier curves.
 *
 * At v every row gives a point; these are the control points of a curve, which is taken at u.
 *
 * @throws RangeError if the net is empty or ragged, dimensions differ or a number is not finite.
 */
export function patchPoint(net: ControlNet, u: number, v: number): Point {
  checkNet("controlPoints", net);
  checkNumber("u", u);
  checkNumber("v", v);
  const moving = net.map((row) => bezierPoint(row, v));
  return bezierPoint(moving, u);
}

/**
 * The partial derivative of order k in u and l in v of a Bézier patch; the zero vector beyond the degrees.
 *
 * @throws RangeError as `patchPoint`, and if k or l is not a whole number ≥ 0.
 */
export function patchPartial(net: ControlNet, u: number, v: number, k: number, l: number): Point {
  checkNet("controlPoints", net);
  checkInteger("k", k, 0);
  checkInteger("l", l, 0);
  checkNumber("u", u);
  checkNumber("v", v);
  const moving = net.map((row) => bezierDerivative(row, v, l));
  return bezierDerivative(moving, u, k);
}

/**
 * The control points of an iso-parametric curve of a Bézier patch: for `fixed` = "u" the curve v → S(value, v).
 *
 * @throws RangeError as `patchPoint`.
 */
export function patchIsoCurve(net: ControlNet, fixed: "u" | "v", value: number): Point[] {
  checkNet("controlPoints", net);
  checkNumber("value", value);
  if (fixed === "v") return net.map((row) => bezierPoint(row, value));
  return net[0]!.map((_, j) =>
    bezierPoint(
      net.map((row) => row[j]!),
      value,
    ),
  );
}

/**
 * The Bézier patch of a control net over [0, 1]², of any degrees m, n ≥ 0 and any dimension.
 *
 * It passes through the four corners and lies in the convex hull of the net. An edge whose control points coincide is a
 * single point of the surface, without a normal (see `limitNormal`).
 *
 * @throws RangeError as `patchPoint`.
 */
export function bezierPatch(net: ControlNet): Surface {
  const dimension = checkNet("controlPoints", net);
  return {
    dimension,
    domain: [
      [0, 1],
      [0, 1],
    ],
    point: (u, v) => patchPoint(net, u, v),
    partial: (u, v, k, l) => patchPartial(net, u, v, k, l),
    speed: longestLeg(net),
  };
}

/** The longest control vector of S_u and S_v: no derivative is longer. */
function longestLeg(net: ControlNet): number {
  const [m, n] = [net.length - 1, net[0]!.length - 1];
  let longest = 0;
  net.forEach((row, i) => {
    row.forEach((point, j) => {
      if (i < m) longest = Math.max(longest, m * distance(point, net[i + 1]![j]!));
      if (j < n) longest = Math.max(longest, n * distance(point, row[j + 1]!));
    });
  });
  return longest;
}
