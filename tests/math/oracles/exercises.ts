import {
  bezierBounds,
  bezierCurve,
  bezierDerivative,
  bezierExtrema,
  bezierPoint,
  classifyJoint,
  distance,
  type Point,
  parallelFactor,
  scale,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";

/** Points closer than this are equal. */
const close = (p: Point, q: Point): boolean => distance(p, q) <= 1e-9;

type BezierExercise = {
  start: Point;
  end: Point;
  startDirection: Point;
  endDirection: Point;
  controlPoints: Point[];
};
type Hermite = { p0: Point; p1: Point; m0: Point; m1: Point };
type Candidate = { form: "hermite" | "bezier" | "monomial"; rows: Point[] };
type SplineExercise = { points: Point[]; criterion: "C1" | "G1"; controlPoints: Point[] };

function directionReason(end: "start" | "end", derivative: Point, factor: number | null): string[] {
  if (close(derivative, scale(derivative, 0))) return [`${end}Zero`];
  if (factor === null) return [`${end}Direction`];
  return factor < 0 ? [`${end}Reversed`] : [];
}

function sum(factors: readonly number[], rows: readonly Point[]): Point {
  return rows[0]!.map((_, axis) => factors.reduce((total, f, i) => total + f * rows[i]![axis]!, 0));
}

/** The matrices that give (p0, m0, m1, p1) of each form. */
const toHermite: Record<Candidate["form"], readonly (readonly number[])[]> = {
  hermite: [
    [1, 0, 0, 0],
    [0, 1, 0, 0],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
  ],
  bezier: [
    [1, 0, 0, 0],
    [-3, 3, 0, 0],
    [0, 0, -3, 3],
    [0, 0, 0, 1],
  ],
  monomial: [
    [0, 0, 0, 1],
    [0, 0, 1, 0],
    [3, 2, 1, 0],
    [1, 1, 1, 1],
  ],
};

const verdict = (reasons: string[]) => ({ accepted: reasons.length === 0, reasons });

export const adapter: Adapter = {
  checkBezierExercise: ({ start, end, startDirection, endDirection, controlPoints }: BezierExercise) => {
    if (controlPoints.length !== 4) return { ...verdict(["count"]), startScale: null, endScale: null };
    const [d0, d1] = [bezierDerivative(controlPoints, 0), bezierDerivative(controlPoints, 1)];
    const startScale = parallelFactor(d0, startDirection);
    const endScale = parallelFactor(d1, endDirection);
    const reasons = [
      ...(close(controlPoints[0]!, start) ? [] : ["start"]),
      ...(close(controlPoints[3]!, end) ? [] : ["end"]),
      ...directionReason("start", d0, startScale),
      ...directionReason("end", d1, endScale),
    ];
    return { ...verdict(reasons), startScale, endScale };
  },
  hermiteExercise: ({ p0, p1, m0, m1, ts }: Hermite & { ts: number[] }) => {
    const bezier = [p0, sum([1, 1 / 3], [p0, m0]), sum([1, -1 / 3], [p1, m1]), p1];
    return {
      points: ts.map((t) => bezierPoint(bezier, t)),
      d1: ts.map((t) => bezierDerivative(bezier, t)),
      bezier,
      coefficients: [3, 2, 1, 0].map((r) => scale(bezierDerivative(bezier, 0, r), 1 / [1, 1, 2, 6][r]!)),
      extrema: bezierExtrema(bezier),
      ...bezierBounds(bezier),
    };
  },
  checkHermiteExercise: ({ p0, p1, m0, m1, candidate }: Hermite & { candidate: Candidate }) => {
    const wanted = { p0, m0, m1, p1 };
    const matrix = toHermite[candidate.form];
    return verdict(
      Object.entries(wanted).flatMap(([name, value], i) =>
        close(sum(matrix[i]!, candidate.rows), value) ? [] : [name],
      ),
    );
  },
  checkSplineExercise: ({ points, criterion, controlPoints }: SplineExercise) => {
    if (controlPoints.length !== 7 && controlPoints.length !== 8) return verdict(["count"]);
    const a = controlPoints.slice(0, 4);
    const b = controlPoints.slice(-4);
    const [start, middle, end] = points as [Point, Point, Point];
    const reasons = [
      ...(close(a[0]!, start) ? [] : ["start"]),
      ...(close(a[3]!, middle) ? [] : ["jointFirst"]),
      ...(close(b[0]!, middle) ? [] : ["jointSecond"]),
      ...(close(b[3]!, end) ? [] : ["end"]),
    ];
    const { regular, tangentAngle, d1Gap } = classifyJoint(bezierCurve(a), bezierCurve(b));
    if (!regular) reasons.push("jointZeroTangent");
    else if (tangentAngle! > 1e-6) reasons.push("jointDirection");
    else if (criterion === "C1" && d1Gap > 1e-8) reasons.push("jointLength");
    return verdict(reasons);
  },
};
