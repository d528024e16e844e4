import {
  bsplineBasis,
  bsplineCurve,
  bsplineToBezier,
  deBoor,
  insertKnot,
  nurbsDerivative,
  type Point,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Basis = { degree: number; knots: number[] };
type Spline = Basis & { controlPoints: Value[] };
type At = { ts: number[]; derivative: number };

export const adapter: Adapter = {
  bsplineBasis: ({ degree, knots, ts, derivative }: Basis & At) => ({
    values: ts.map((t) => bsplineBasis(degree, knots, t, derivative)),
  }),
  bsplineEvaluate: ({ degree, knots, controlPoints, ts, derivative }: Spline & At) => {
    const curve = bsplineCurve(degree, knots, controlPoints.map(toPoint));
    return { values: ts.map((t) => toValue(curve.derivative(t, derivative), controlPoints[0]!)) };
  },
  deBoor: ({ degree, knots, controlPoints, t }: Spline & { t: number }) => {
    const { span, levels } = deBoor(degree, knots, controlPoints.map(toPoint), t);
    return { span, levels: levels.map((level) => level.map((point) => toValue(point, controlPoints[0]!))) };
  },
  knotInsertion: ({ degree, knots, controlPoints, t, times }: Spline & { t: number; times: number }) => {
    const refined = insertKnot(degree, knots, controlPoints.map(toPoint), t, times);
    return {
      knots: refined.knots,
      controlPoints: refined.controlPoints.map((point) => toValue(point, controlPoints[0]!)),
    };
  },
  bsplineToBezier: ({ degree, knots, controlPoints }: Spline) => {
    const { breaks, segments } = bsplineToBezier(degree, knots, controlPoints.map(toPoint));
    return { breaks, segments: segments.map((s) => s.map((point) => toValue(point, controlPoints[0]!))) };
  },
  nurbsEvaluate: (input: Basis & At & { controlPoints: Point[]; weights: number[] }) => ({
    values: input.ts.map((t) => nurbsDerivative(input, t, input.derivative)),
  }),
};
