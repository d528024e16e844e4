import { binomial } from "./bernstein.ts";
import { checkInteger, checkNumber, checkPoints, checkSameLength } from "./check.ts";
import { checkOrdered } from "./check-ordered.ts";
import { bezierCurve, type Curve } from "./curve.ts";
import { add, type Point, scale, zero } from "./point.ts";

/** One Hermite polynomial on [0, 1]: the data it belongs to and its exact coefficients, ascending. */
export type HermitePolynomial = {
  /** The end: 0 for t = 0, 1 for t = 1. */
  readonly i: 0 | 1;
  /** The order of the derivative that this polynomial has equal to 1 there; all others 0 … m at both ends are 0. */
  readonly k: number;
  readonly numerators: readonly number[];
  readonly denominator: number;
  readonly coefficients: readonly number[];
};

/**
 * The 2m + 2 Hermite polynomials of order m on [0, 1], of degree 2m + 1: H_{0,0} … H_{0,m}, H_{1,0} … H_{1,m}.
 *
 * They meet the δ-condition d^r/dt^r H_{i,k}(j) = δ_ij·δ_kr for r, k ≤ m and i, j ∈ {0, 1}. Closed form:
 * H_{0,k}(t) = t^k/k! · (1−t)^{m+1} · Σ_j (m+j over j)·t^j for j = 0 … m−k, and H_{1,k}(t) = (−1)^k·H_{0,k}(1−t).
 * Computed in whole numbers; the numerators are exact as long as doubles hold them (m ≤ 12).
 *
 * @throws RangeError if m is not a whole number ≥ 0.
 */
export function hermiteBasisCoefficients(m: number): HermitePolynomial[] {
  checkInteger("m", m, 0);
  const orders = Array.from({ length: m + 1 }, (_, k) => k);
  const start = orders.map((k) => startPolynomial(m, k));
  return [
    ...orders.map((k) => reduced(0, k, start[k]!)),
    ...orders.map((k) =>
      reduced(
        1,
        k,
        mirrored(start[k]!).map((c) => (k % 2 === 0 ? c : -c)),
      ),
    ),
  ];
}

/** Ascending coefficients of k!·H_{0,k}. */
function startPolynomial(m: number, k: number): bigint[] {
  const sum: bigint[] = [];
  for (let j = 0; j <= m - k; j++) sum.push(choose(m + j, j));
  let product: bigint[] = [...new Array<bigint>(k).fill(0n), ...sum];
  for (let step = 0; step <= m; step++) product = timesOneMinusT(product);
  return product;
}

/** Ascending coefficients of q(1 − t), from the inside out (Horner). */
function mirrored(q: readonly bigint[]): bigint[] {
  const highest = q.length - 1;
  let value = [q[highest]!];
  for (let i = highest - 1; i >= 0; i--) {
    value = timesOneMinusT(value);
    value[0] = value[0]! + q[i]!;
  }
  return value;
}

/** (1 − t)·p(t). */
function timesOneMinusT(p: readonly bigint[]): bigint[] {
  return [...p, 0n].map((c, i) => (i > 0 ? c - p[i - 1]! : c));
}

function choose(n: number, k: number): bigint {
  let result = 1n;
  for (let j = 1; j <= k; j++) result = (result * BigInt(n - k + j)) / BigInt(j);
  return result;
}

/** Divides the coefficients by k! and takes out common factors. */
function reduced(i: 0 | 1, k: number, numerators: readonly bigint[]): HermitePolynomial {
  let denominator = 1n;
  for (let j = 2; j <= k; j++) denominator *= BigInt(j);
  const common = numerators.reduce(gcd, denominator);
  const exact = numerators.map((c) => Number(c / common));
  const below = Number(denominator / common);
  return { i, k, numerators: exact, denominator: below, coefficients: exact.map((c) => c / below) };
}

function gcd(a: bigint, b: bigint): bigint {
  let [x, y] = [a < 0n ? -a : a, b < 0n ? -b : b];
  while (y > 0n) [x, y] = [y, x % y];
  return x;
}

/**
 * The Bézier control points of the polynomial of degree 2m + 1 with given derivatives of order 0 … m at both ends of an
 * interval of length h.
 *
 * The derivatives at one end fix the control points next to it: c_j = Σ_k (j over k)·(n−k)!/n!·h^k·P^{(k)}, k = 0 … j,
 * with n = 2m + 1; at the far end with (−h)^k. In this form evaluation is stable for every m.
 */
function controlPoints(start: readonly Point[], end: readonly Point[], h: number): Point[] {
  const n = 2 * start.length - 1;
  const side = (derivatives: readonly Point[], length: number) =>
    derivatives.map((_, j) => {
      let point = zero(derivatives[0]!.length);
      let factor = 1; // (n−k)!/n!·h^k
      for (let k = 0; k <= j; k++) {
        point = add(point, scale(derivatives[k]!, binomial(j, k) * factor));
        factor *= length / (n - k);
      }
      return point;
    });
  return [...side(start, h), ...side(end, -h).reverse()];
}

/**
 * The two-point Hermite problem of any order m: the polynomial of degree 2m + 1 on [t0, t1] with the derivatives
 * start[0], …, start[m] at t0 and end[0], …, end[m] at t1 (index 0: the point itself).
 *
 * Derivatives refer to t: on an interval of length h the local derivative of order k is h^k times as long.
 *
 * @throws RangeError if not t0 < t1, if the lists are empty or differ in length, dimensions differ or a number is not
 * finite.
 */
export function hermiteCurve(t0: number, t1: number, start: readonly Point[], end: readonly Point[]): Curve {
  checkOrdered("t0", t0, "t1", t1);
  const dimension = checkPoints("start", start);
  checkPoints("end", end, 1, dimension);
  checkSameLength("end", end, "start", start);
  return bezierCurve(controlPoints(start, end, t1 - t0), [t0, t1]);
}

/**
 * All Hermite polynomials of order m on [t0, t1] as the coordinates of one curve, H_{0,0} … H_{0,m}, H_{1,0} … H_{1,m}:
 * the solution of the Hermite problem whose data are the unit vectors.
 *
 * @throws RangeError if not t0 < t1 or m is not a whole number ≥ 0.
 */
export function hermiteBasisCurve(m: number, t0: number, t1: number): Curve {
  checkInteger("m", m, 0);
  const count = 2 * m + 2;
  const unit = (k: number): Point => Array.from({ length: count }, (_, axis) => (axis === k ? 1 : 0));
  const orders = Array.from({ length: m + 1 }, (_, k) => k);
  return hermiteCurve(
    t0,
    t1,
    orders.map((k) => unit(k)),
    orders.map((k) => unit(m + 1 + k)),
  );
}

/**
 * The Hermite polynomials of order m on [t0, t1] at t, or their r-th derivatives: `values[i][k]` is H_{i,k}^{(r)}(t). For
 * many parameters make a `hermiteBasisCurve` once.
 *
 * H_{i,k}(t) = h^k · H_{i,k}((t − t0)/h) with the polynomials of [0, 1] on the right, h = t1 − t0.
 *
 * @throws RangeError if not t0 < t1, m or r is not a whole number ≥ 0 or t is not finite.
 */
export function hermiteBasis(m: number, t0: number, t1: number, t: number, r = 0): [Point, Point] {
  checkInteger("r", r, 0);
  checkNumber("t", t);
  const values = hermiteBasisCurve(m, t0, t1).derivative(t, r);
  return [values.slice(0, m + 1), values.slice(m + 1)];
}
