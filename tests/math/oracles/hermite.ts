import {
  hermiteBasis,
  hermiteBasisCoefficients,
  hermiteCoefficientMatrix,
  hermiteCoefficients,
  hermiteCubicBasis,
  hermiteCubicBasisPointsFirst,
  hermiteCurve,
  hermiteMatrix,
  hermitePoint,
  hermiteToBezier,
  type Point,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Order = { m: number; t0: number; t1: number; ts: number[]; derivative: number };
type Segment = { p0: Value; m0: Value; m1: Value; p1: Value; ts: number[] };

export const adapter: Adapter = {
  hermiteBasisCoefficients: ({ m }: { m: number }) => ({ basis: hermiteBasisCoefficients(m) }),
  hermiteBasis: ({ m, t0, t1, ts, derivative }: Order) => ({
    values: ts.map((t) => hermiteBasis(m, t0, t1, t, derivative)),
  }),
  hermiteInterpolate: ({ m, t0, t1, P0, P1, ts, derivative }: Order & { P0: Value[]; P1: Value[] }) => {
    if (P0.length !== m + 1) throw new Error(`P0 has ${P0.length} derivatives, not m + 1 = ${m + 1}`);
    const curve = hermiteCurve(t0, t1, P0.map(toPoint), P1.map(toPoint));
    return { values: ts.map((t) => toValue(curve.derivative(t, derivative), P0[0]!)) };
  },
  hermiteSegment: ({ p0, m0, m1, p1, ts }: Segment) => {
    const geometry = [p0, m0, m1, p1].map(toPoint) as [Point, Point, Point, Point];
    const like = (points: readonly Point[]) => points.map((point) => toValue(point, p0));
    const [A, B, C, D] = like(hermiteCoefficients(...geometry));
    const derivative = (r: number) => like(ts.map((t) => hermitePoint(...geometry, t, r)));
    return {
      A,
      B,
      C,
      D,
      points: derivative(0),
      d1: derivative(1),
      d2: derivative(2),
      d3: derivative(3),
      bezier: like(hermiteToBezier(...geometry)),
    };
  },
  hermiteMatrix: ({ tr, tr1 }: { tr: number; tr1: number }) => hermiteMatrix(tr, tr1),
  hermiteMH: ({ tr, tr1, G }: { tr: number; tr1: number; G: Value[] }) => ({
    MH: hermiteCoefficientMatrix(tr, tr1, G.map(toPoint)).map((row) => toValue(row, G[0]!)),
  }),
  hermiteCubicBasis: ({ ts }: { ts: number[] }) => ({
    H0123: ts.map((t) => hermiteCubicBasis(t)),
    Hr0_Hr10_Hr1_Hr11: ts.map((t) => hermiteCubicBasisPointsFirst(t)),
  }),
};
