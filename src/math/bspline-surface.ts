import { type ControlNet, checkNet } from "./bezier-patch.ts";
import { bsplineDerivatives, bsplineHodograph } from "./bspline.ts";
import { bsplineToBezier } from "./insert-knot.ts";
import { checkCurveKnots, knotDomain } from "./knots.ts";
import { norm, type Point } from "./point.ts";
import type { Surface } from "./surface.ts";

/** The data of a tensor-product B-spline surface; `controlPoints[i][j]`, i running with u and j with v. */
export type BSplineSurface = {
  readonly degreeU: number;
  readonly degreeV: number;
  readonly knotsU: readonly number[];
  readonly knotsV: readonly number[];
  readonly controlPoints: ControlNet;
};

/**
 * The tensor-product B-spline surface Σ_i Σ_j d_ij · N_i^p(u) · N_j^q(v): a B-spline curve of B-spline curves.
 *
 * Derivatives at a knot are taken from the right, at the right end of the domain from the left.
 *
 * @throws RangeError if the net is empty or ragged, dimensions differ, a number is not finite or for bad knots in u or v
 * (see `checkCurveKnots`).
 */
export function bsplineSurface(data: BSplineSurface): Surface {
  const dimension = check(data);
  const { degreeU, degreeV, knotsU, knotsV, controlPoints } = data;
  const rows = controlPoints.map((row) =>
    bsplineDerivatives({ degree: degreeV, knots: knotsV, controlPoints: row }),
  );
  const partial = (u: number, v: number, k: number, l: number): Point => {
    const moving = rows.map((row) => row(v, l));
    return bsplineDerivatives({ degree: degreeU, knots: knotsU, controlPoints: moving })(u, k);
  };
  return {
    dimension,
    domain: [knotDomain(degreeU, knotsU), knotDomain(degreeV, knotsV)],
    point: (u, v) => partial(u, v, 0, 0),
    partial,
    speed: longestLeg(data),
  };
}

/**
 * The Bézier patches of a tensor-product B-spline surface: `patches[a][b]` over the a-th span of u and the b-th of v,
 * whose ends are listed.
 *
 * @throws RangeError as `bsplineSurface`.
 */
export function bsplineSurfaceToPatches(data: BSplineSurface): {
  readonly breaksU: number[];
  readonly breaksV: number[];
  readonly patches: Point[][][][];
} {
  check(data);
  const { degreeU, degreeV, knotsU, knotsV, controlPoints } = data;
  const rows = controlPoints.map((row) => bsplineToBezier(degreeV, knotsV, row));
  const { breaks: breaksV, segments } = rows[0]!;
  const strips = segments.map((_, b) => {
    const strip = transpose(rows.map((row) => row.segments[b]!));
    return strip.map((column) => bsplineToBezier(degreeU, knotsU, column));
  });
  const { breaks: breaksU } = strips[0]![0]!;
  const patches = breaksU
    .slice(1)
    .map((_, a) => strips.map((columns) => transpose(columns.map((column) => column.segments[a]!))));
  return { breaksU, breaksV, patches };
}

function check({ degreeU, degreeV, knotsU, knotsV, controlPoints }: BSplineSurface): number {
  const dimension = checkNet("controlPoints", controlPoints);
  named("U", () => checkCurveKnots(degreeU, knotsU, controlPoints.length));
  named("V", () => checkCurveKnots(degreeV, knotsV, controlPoints[0]!.length));
  return dimension;
}

/** Lets an error about `knots` or `degree` name the direction. */
function named(direction: "U" | "V", run: () => void): void {
  try {
    run();
  } catch (error) {
    const { message } = error as RangeError;
    throw new RangeError(message.replace(/^(knots|degree)/, `$1${direction}`));
  }
}

function transpose<T>(rows: readonly (readonly T[])[]): T[][] {
  return rows[0]!.map((_, j) => rows.map((row) => row[j]!));
}

/** The longest control vector of S_u and S_v: no derivative is longer. */
function longestLeg({ degreeU, degreeV, knotsU, knotsV, controlPoints }: BSplineSurface): number {
  const legs = [
    ...controlPoints.map((row) => ({ degree: degreeV, knots: knotsV, controlPoints: row })),
    ...transpose(controlPoints).map((column) => ({ degree: degreeU, knots: knotsU, controlPoints: column })),
  ].flatMap((spline) => bsplineHodograph(spline).controlPoints);
  return legs.reduce((longest, leg) => Math.max(longest, norm(leg)), 0);
}
