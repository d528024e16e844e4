import {
  bernstein,
  bernsteinDerivative,
  bezierDerivative,
  deCasteljau,
  elevateDegree,
  type Point,
  splitBezier,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";

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
};
