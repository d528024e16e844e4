import {
  catmullRom,
  catmullRomSegment,
  type HermiteSpline,
  parabolicBlend,
  parabolicCoefficients,
  splineToBezier,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Points = { points: Value[] };
type Parametrized = Points & { alpha: number };

/** The points of each segment at local parameters. */
const alongSegments = ({ nodes, point }: HermiteSpline, us: number[], sample: Value) =>
  nodes.slice(1).map((next, r) => us.map((u) => toValue(point(nodes[r]! + u * (next - nodes[r]!)), sample)));

export const adapter: Adapter = {
  parabolicBlend: ({ points, ts, derivative }: Points & { ts: number[]; derivative: number }) => {
    const data = points.map(toPoint);
    const segments = data.slice(1).map((_, r) => r);
    // Values by the blending itself, derivatives by the coefficients.
    const at = (r: number, t: number) => {
      if (derivative === 0) return parabolicBlend(data, r, t);
      const [a, b, c] = parabolicCoefficients(data)[r]!;
      const weights = [
        [3 * t * t, 2 * t, 1],
        [6 * t, 2, 0],
        [6, 0, 0],
      ][derivative - 1] ?? [0, 0, 0];
      return a.map((x, axis) => weights[0]! * x + weights[1]! * b[axis]! + weights[2]! * c[axis]!);
    };
    return { segments: segments.map((r) => ts.map((t) => toValue(at(r, t), points[0]!))) };
  },
  parabolicCoefficients: ({ points }: Points) => ({
    segments: parabolicCoefficients(points.map(toPoint)).map((coefficients) =>
      coefficients.map((c) => toValue(c, points[0]!)),
    ),
  }),
  catmullRom: ({ points, alpha, us }: Parametrized & { us: number[] }) => {
    const spline = catmullRom(points.map(toPoint), alpha);
    return { knots: spline.nodes, segments: alongSegments(spline, us, points[0]!) };
  },
  catmullRomBezier: ({ points, alpha }: Parametrized) => ({
    bezier: splineToBezier(catmullRom(points.map(toPoint), alpha)).map((segment) =>
      segment.map((c) => toValue(c, points[0]!)),
    ),
  }),
  catmullRomSegment: ({ points, alpha, us }: Parametrized & { us: number[] }) => {
    const segment = catmullRomSegment(points.map(toPoint), alpha);
    return {
      points: us.map((u) => toValue(segment.point(u), points[0]!)),
      startTangent: toValue(segment.startTangent, points[0]!),
      endTangent: toValue(segment.endTangent, points[0]!),
    };
  },
};
