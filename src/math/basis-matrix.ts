import { checkPoints } from "./check.ts";
import {
  applyToGeometry,
  identity4,
  invert4,
  type Matrix4,
  multiply4,
  type Row4,
  rowTimes4,
} from "./matrix4.ts";
import { combine, type Point } from "./point.ts";

/**
 * The bases of the cubic polynomials that the course knows by name. A curve is p(t) = [t³ t² t 1] · M · G; the
 * geometry vector G holds
 * - `monomial`: the coefficients (A, B, C, D), highest power first,
 * - `hermite`: (p₀, m₀, m₁, p₁), points and tangents in the order of the curve,
 * - `hermitePointsFirst`: (p₀, p₁, m₀, m₁), the other order: the same columns, permuted,
 * - `bezier`: the control points (c₀, c₁, c₂, c₃),
 * - `catmullRom`: four points of which the uniform curve joins the inner two,
 * - `bspline`: four control points of a uniform cubic B-spline.
 */
export const basisNames = [
  "monomial",
  "hermite",
  "hermitePointsFirst",
  "bezier",
  "catmullRom",
  "bspline",
] as const;
export type BasisName = (typeof basisNames)[number];

/** A basis matrix as whole numbers over a common denominator: what a formula shows. */
export type ExactMatrix4 = {
  readonly numerators: Matrix4;
  readonly denominator: number;
};

const exact: Readonly<Record<BasisName, ExactMatrix4>> = {
  monomial: { denominator: 1, numerators: identity4 },
  hermite: {
    denominator: 1,
    numerators: [
      [2, 1, 1, -2],
      [-3, -2, -1, 3],
      [0, 1, 0, 0],
      [1, 0, 0, 0],
    ],
  },
  hermitePointsFirst: {
    denominator: 1,
    numerators: [
      [2, -2, 1, 1],
      [-3, 3, -2, -1],
      [0, 0, 1, 0],
      [1, 0, 0, 0],
    ],
  },
  bezier: {
    denominator: 1,
    numerators: [
      [-1, 3, -3, 1],
      [3, -6, 3, 0],
      [-3, 3, 0, 0],
      [1, 0, 0, 0],
    ],
  },
  catmullRom: {
    denominator: 2,
    numerators: [
      [-1, 3, -3, 1],
      [2, -5, 4, -1],
      [-1, 0, 1, 0],
      [0, 2, 0, 0],
    ],
  },
  bspline: {
    denominator: 6,
    numerators: [
      [-1, 3, -3, 1],
      [3, -6, 3, 0],
      [-3, 0, 3, 0],
      [1, 4, 1, 0],
    ],
  },
};

/** The basis matrix M as whole numbers and their common denominator. */
export function exactBasisMatrix(basis: BasisName): ExactMatrix4 {
  const matrix = exact[basis];
  if (!matrix) throw new RangeError(`basis: expected one of ${basisNames.join(", ")}, got "${basis}"`);
  return matrix;
}

/**
 * The 4×4 basis matrix M of p(t) = [t³ t² t 1] · M · G.
 *
 * @throws RangeError for an unknown name.
 */
export function basisMatrix(basis: BasisName): Matrix4 {
  const { numerators, denominator } = exactBasisMatrix(basis);
  return numerators.map((row) => row.map((entry) => entry / denominator)) as unknown as Matrix4;
}

/** The powers [t³ t² t 1]; its r-th derivative for r > 0. */
export function powers4(t: number, r = 0): Row4 {
  if (r === 0) return [t * t * t, t * t, t, 1];
  if (r === 1) return [3 * t * t, 2 * t, 1, 0];
  if (r === 2) return [6 * t, 2, 0, 0];
  return r === 3 ? [6, 0, 0, 0] : [0, 0, 0, 0];
}

/** The four blending functions [t³ t² t 1] · M at t: the weights of the geometry vector. Any 4×4 matrix, any t. */
export function blendingFunctions(matrix: Matrix4, t: number, r = 0): Row4 {
  return rowTimes4(powers4(t, r), matrix);
}

/**
 * The point [t³ t² t 1] · M · G, or its r-th derivative with respect to t. Any 4×4 matrix, any t, any dimension.
 *
 * @throws RangeError unless the geometry vector holds four points of one dimension.
 */
export function matrixPoint(matrix: Matrix4, geometry: readonly Point[], t: number, r = 0): Point {
  checkGeometry(geometry);
  return combine(blendingFunctions(matrix, t, r), geometry);
}

/**
 * The matrix that turns a geometry vector of one basis into that of another: G_to = M_to⁻¹ · M_from · G_from.
 *
 * `from` and `to` are names or 4×4 matrices of one's own. `null` if `to` has no inverse, so is no basis.
 *
 * @throws RangeError for an unknown name or a number that is not finite.
 */
export function conversionMatrix(from: BasisName | Matrix4, to: BasisName | Matrix4): Matrix4 | null {
  const inverse = invert4(matrixOf(to));
  return inverse && multiply4(inverse, matrixOf(from));
}

/**
 * The geometry vector of the same curve in another basis; `null` if `to` is no basis (see `conversionMatrix`).
 *
 * @throws RangeError for an unknown name, a number that is not finite, or other than four points of one dimension.
 */
export function convertBasis(
  geometry: readonly Point[],
  from: BasisName | Matrix4,
  to: BasisName | Matrix4,
): Point[] | null {
  checkGeometry(geometry);
  const conversion = conversionMatrix(from, to);
  return conversion && applyToGeometry(conversion, geometry);
}

function matrixOf(basis: BasisName | Matrix4): Matrix4 {
  return typeof basis === "string" ? basisMatrix(basis) : basis;
}

function checkGeometry(geometry: readonly Point[]): void {
  checkPoints("geometry", geometry, 4);
  if (geometry.length !== 4) throw new RangeError(`geometry: expected 4 points, got ${geometry.length}`);
}
