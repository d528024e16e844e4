import {
  cubicDoublePoint,
  nodalCubicBranch,
  nodalCubicGradient,
  nodalCubicOrdinates,
  nodalCubicParameters,
  nodalCubicPoint,
  nodalCubicTangent,
  nodalCubicValue,
  type Point,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";

export const adapter: Adapter = {
  parametricEvaluate: ({ ts }: { ts: number[] }) => ({
    points: ts.map(nodalCubicPoint),
    tangents: ts.map(nodalCubicTangent),
  }),
  explicitEvaluate: ({ xs }: { xs: number[] }) => ({ ys: xs.map(nodalCubicBranch) }),
  implicitEvaluate: ({ points }: { points: Point[] }) => ({
    values: points.map(nodalCubicValue),
    gradients: points.map(nodalCubicGradient),
  }),
  parametersOfPoint: ({ points }: { points: Point[] }) => ({
    parameters: points.map((point) => nodalCubicParameters(point)),
  }),
  ordinatesOfImplicit: ({ xs }: { xs: number[] }) => ({ ys: xs.map(nodalCubicOrdinates) }),
  cubicDoublePoint: ({ x, y }: { x: number[]; y: number[] }) =>
    cubicDoublePoint(x.map((value, i) => [value, y[i]!])),
};
