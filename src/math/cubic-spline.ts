import { type HermiteSpline, hermiteSpline } from "./hermite-spline.ts";
import type { Point } from "./point.ts";
import { type SplineEnd, splineSystem } from "./spline-system.ts";
import { solveCyclic, solveTridiagonal, type TridiagonalSystem } from "./tridiagonal.ts";

/** A C² Hermite spline with the linear system that its tangents solve. */
export type CubicSpline = HermiteSpline & {
  readonly end: SplineEnd;
  readonly system: TridiagonalSystem;
};

/**
 * The cubic spline through points at ascending nodes: piecewise cubic, C², with the given condition at its ends.
 *
 * Global: moving one point changes every tangent, but its influence fades by √3 − 2 ≈ −0.268 per (uniform) node. Built
 * in time linear in the number of points.
 *
 * @throws RangeError as `splineSystem`.
 */
export function cubicSpline(nodes: readonly number[], points: readonly Point[], end: SplineEnd): CubicSpline {
  const system = splineSystem(nodes, points, end);
  const tangents = tangentsOf(system, end);
  return { ...hermiteSpline(nodes, points, tangents), end, system };
}

/** The tangents (first derivatives) of the cubic spline at its nodes. @throws RangeError as `splineSystem`. */
export function cubicSplineTangents(
  nodes: readonly number[],
  points: readonly Point[],
  end: SplineEnd,
): Point[] {
  return tangentsOf(splineSystem(nodes, points, end), end);
}

function tangentsOf(system: TridiagonalSystem, end: SplineEnd): Point[] {
  if (end.type !== "periodic") return solveTridiagonal(system);
  const tangents = solveCyclic(system);
  return [...tangents, tangents[0]!];
}
