import { cubicSpline, type SplineEnd, segmentMoments } from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Boundary = { type: SplineEnd["type"]; start: Value; end: Value };
type Input = { knots: number[]; points: Value[]; boundary: Boundary };

const splineOf = ({ knots, points, boundary }: Input) => {
  const { type } = boundary;
  const end: SplineEnd =
    type === "clamped" ? { type, start: toPoint(boundary.start), end: toPoint(boundary.end) } : { type };
  return cubicSpline(knots, points.map(toPoint), end);
};

export const adapter: Adapter = {
  splineKnotDerivatives: (input: Input) => ({
    first: splineOf(input).tangents.map((tangent) => toValue(tangent, input.points[0]!)),
  }),
  splineKnotMoments: (input: Input) => {
    const spline = splineOf(input);
    const last = input.knots.length - 2;
    const moments = [
      ...input.knots.slice(1).map((_, i) => segmentMoments(spline, i)[0]),
      segmentMoments(spline, last)[1],
    ];
    return { second: moments.map((moment) => toValue(moment, input.points[0]!)) };
  },
  splineEvaluate: (input: Input & { ts: number[]; derivative: number }) => {
    const spline = splineOf(input);
    return { values: input.ts.map((t) => toValue(spline.derivative(t, input.derivative), input.points[0]!)) };
  },
};
