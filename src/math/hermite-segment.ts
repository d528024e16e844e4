import { checkNumber, checkPoint, checkPoints } from "./check.ts";
import { applyToGeometry, type Matrix4, type Row4 } from "./matrix4.ts";
import { add, combine, type Point, scale, sub } from "./point.ts";

/**
 * The four cubic Hermite polynomials [H_0, H_1, H_2, H_3] at t, for the geometry vector (p₀, m₀, m₁, p₁), or their
 * r-th derivatives.
 *
 * H_0 = (1−t)²(1+2t), H_1 = t(1−t)², H_2 = −t²(1−t), H_3 = t²(3−2t). H_0 + H_3 = 1, but all four do not add up to 1:
 * m₀ and m₁ are vectors. H_2 reaches −4/27 at t = 2/3.
 */
export function hermiteCubicBasis(t: number, r = 0): Row4 {
  const s = 1 - t;
  if (r === 0) return [s * s * (1 + 2 * t), t * s * s, -t * t * s, t * t * (3 - 2 * t)];
  if (r === 1) return [-6 * t * s, s * (1 - 3 * t), t * (3 * t - 2), 6 * t * s];
  if (r === 2) return [12 * t - 6, 6 * t - 4, 6 * t - 2, 6 - 12 * t];
  return r === 3 ? [12, 6, 6, -12] : [0, 0, 0, 0];
}

/** The same for the other order of the geometry vector, (p₀, p₁, m₀, m₁): [H_{r,0}, H_{r+1,0}, H_{r,1}, H_{r+1,1}]. */
export function hermiteCubicBasisPointsFirst(t: number, r = 0): Row4 {
  const [h0, h1, h2, h3] = hermiteCubicBasis(t, r);
  return [h0, h3, h1, h2];
}

/**
 * The point of the cubic Hermite segment from p₀ to p₁ with the derivatives m₀ and m₁ at its ends, t in [0, 1], or its
 * r-th derivative. Outside [0, 1] the cubic is continued.
 *
 * @throws RangeError if dimensions differ or a number is not finite.
 */
export function hermitePoint(p0: Point, m0: Point, m1: Point, p1: Point, t: number, r = 0): Point {
  checkSegment(p0, m0, m1, p1);
  checkNumber("t", t);
  return combine(hermiteCubicBasis(t, r), [p0, m0, m1, p1]);
}

/**
 * The coefficients [A, B, C, D] of the segment as A·t³ + B·t² + C·t + D, t in [0, 1].
 *
 * @throws RangeError if dimensions differ or a number is not finite.
 */
export function hermiteCoefficients(
  p0: Point,
  m0: Point,
  m1: Point,
  p1: Point,
): [Point, Point, Point, Point] {
  checkSegment(p0, m0, m1, p1);
  const chord = sub(p1, p0);
  const a = add(scale(chord, -2), add(m0, m1));
  const b = sub(scale(chord, 3), add(scale(m0, 2), m1));
  return [a, b, m0, p0];
}

/**
 * The Bézier control points (c₀, c₁, c₂, c₃) of the segment: m₀ = 3·(c₁ − c₀), m₁ = 3·(c₃ − c₂).
 *
 * @throws RangeError if dimensions differ or a number is not finite.
 */
export function hermiteToBezier(p0: Point, m0: Point, m1: Point, p1: Point): [Point, Point, Point, Point] {
  checkSegment(p0, m0, m1, p1);
  return [p0, add(p0, scale(m0, 1 / 3)), sub(p1, scale(m1, 1 / 3)), p1];
}

/**
 * The geometry vector (p₀, m₀, m₁, p₁) of a cubic Bézier curve.
 *
 * @throws RangeError unless there are four control points of one dimension with finite coordinates.
 */
export function bezierToHermite(controlPoints: readonly Point[]): [Point, Point, Point, Point] {
  checkPoints("controlPoints", controlPoints, 4);
  if (controlPoints.length !== 4) {
    throw new RangeError(`controlPoints: expected 4 points, got ${controlPoints.length}`);
  }
  const [c0, c1, c2, c3] = controlPoints as [Point, Point, Point, Point];
  return [c0, scale(sub(c1, c0), 3), scale(sub(c3, c2), 3), c3];
}

/**
 * The matrix K that a cubic [t³ t² t 1]·C meets at the ends of [t_r, t_{r+1}]: K·C = (P_r, P_{r+1}, P′_r, P′_{r+1}),
 * and its inverse, the Hermite basis matrix: C = K⁻¹·G.
 *
 * The four rows of K are four substitutions: both ends into the curve, both ends into its derivative.
 * det K = −(t_{r+1} − t_r)⁴ ≠ 0. The columns of K⁻¹ are the coefficients of the Hermite polynomials, multiplied out in
 * t, which keeps them accurate far from t = 0.
 *
 * @throws RangeError if a number is not finite, t_r = t_{r+1} or the cube of their difference underflows.
 */
export function hermiteMatrix(tr: number, tr1: number): { readonly K: Matrix4; readonly Kinv: Matrix4 } {
  checkNumber("tr", tr);
  checkNumber("tr1", tr1);
  const h = tr1 - tr;
  // The cube, because it is divided by: it vanishes for h = 0 and where h is too short for doubles.
  if (h ** 3 === 0)
    throw new RangeError(`tr1: expected a number clearly different from tr = ${tr}, got ${tr1}`);
  const value = (t: number): Row4 => [t * t * t, t * t, t, 1];
  const slope = (t: number): Row4 => [3 * t * t, 2 * t, 1, 0];
  const points = (row: Row4) => row.map((entry) => entry / h ** 3);
  const tangents = (row: Row4) => row.map((entry) => entry / h ** 2);
  const columns = [
    points([2, -3 * (tr + tr1), 6 * tr * tr1, tr1 * tr1 * (tr1 - 3 * tr)]),
    points([-2, 3 * (tr + tr1), -6 * tr * tr1, tr * tr * (3 * tr1 - tr)]),
    tangents([1, -(tr + 2 * tr1), tr1 * (2 * tr + tr1), -tr * tr1 * tr1]),
    tangents([1, -(2 * tr + tr1), tr * (tr + 2 * tr1), -tr * tr * tr1]),
  ];
  const Kinv = [0, 1, 2, 3].map((i) => columns.map((column) => column[i]!)) as unknown as Matrix4;
  return { K: [value(tr), value(tr1), slope(tr), slope(tr1)], Kinv };
}

/**
 * The coefficients C = K⁻¹·G (rows for t³, t², t, 1) of the cubic over [t_r, t_{r+1}] with the geometry vector
 * G = (P_r, P_{r+1}, P′_r, P′_{r+1}).
 *
 * @throws RangeError as `hermiteMatrix`, and unless G holds four points of one dimension.
 */
export function hermiteCoefficientMatrix(tr: number, tr1: number, geometry: readonly Point[]): Point[] {
  checkPoints("geometry", geometry, 4);
  if (geometry.length !== 4) throw new RangeError(`geometry: expected 4 points, got ${geometry.length}`);
  return applyToGeometry(hermiteMatrix(tr, tr1).Kinv, geometry);
}

function checkSegment(p0: Point, m0: Point, m1: Point, p1: Point): void {
  checkPoint("p0", p0);
  checkPoint("m0", m0, p0.length);
  checkPoint("m1", m1, p0.length);
  checkPoint("p1", p1, p0.length);
}
