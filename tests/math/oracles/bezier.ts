import {
  arclength,
  bernstein,
  bernsteinDerivative,
  bezierBounds,
  bezierCurve,
  bezierDerivative,
  bezierExtrema,
  bezierInflections,
  convexHull,
  curvature,
  deCasteljau,
  elevateDegree,
  type Point,
  rationalBezierDerivative,
  splitBezier,
  torsion,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";

type Rational = Points & { weights: number[]; ts: number[]; derivative: number };
type Points = { controlPoints: Point[] };

export const adapter: Adapter = {
  bernstein: ({ degree, ts, derivative }: { degree: number; ts: number[]; derivative: number }) => ({
    values: ts.map((t) =>
      Array.from({ length: degree + 1 }, (_, i) =>
        derivative === 0 ? bernstein(degree, i, t) : bernsteinDerivative(degree, i, t, derivative),
      ),
    ),
  }),
  bezierEvaluate: ({ controlPoints, ts, derivative }: Points & { ts: number[]; derivative: number }) => ({
    values: ts.map((t) => bezierDerivative(controlPoints, t, derivative)),
  }),
  deCasteljau: ({ controlPoints, t }: Points & { t: number }) => ({ levels: deCasteljau(controlPoints, t) }),
  bezierSplit: ({ controlPoints, t }: Points & { t: number }) => {
    const [left, right] = splitBezier(controlPoints, t);
    return { left, right };
  },
  bezierElevate: ({ controlPoints, times }: Points & { times: number }) => ({
    controlPoints: elevateDegree(controlPoints, times),
  }),
  bezierCurvature: ({ controlPoints, ts }: Points & { ts: number[] }) => {
    const curve = bezierCurve(controlPoints);
    const signed = ts.map((t) => curvature(curve, t));
    return {
      signedCurvature: curve.dimension === 2 ? signed : null,
      curvature: signed.map((value) => value && Math.abs(value)),
      torsion: curve.dimension === 3 ? ts.map((t) => torsion(curve, t)) : null,
    };
  },
  bezierArcLength: ({ controlPoints, t0, t1 }: Points & { t0: number; t1: number }) => ({
    length: arclength(bezierCurve(controlPoints), 1e-13, t0, t1),
  }),
  bezierBoundingBox: ({ controlPoints }: Points) => bezierBounds(controlPoints),
  bezierExtrema: ({ controlPoints }: Points) => ({ ts: bezierExtrema(controlPoints) }),
  bezierInflections: ({ controlPoints }: Points) => ({ ts: bezierInflections(controlPoints) }),
  convexHull: ({ points }: { points: Point[] }) => ({ hull: convexHull(points) }),
  rationalBezierEvaluate: ({ controlPoints, weights, ts, derivative }: Rational) => ({
    values: ts.map((t) => rationalBezierDerivative(controlPoints, weights, t, derivative)),
  }),
};
