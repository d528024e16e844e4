import { checkInteger, checkInterval, checkNonDecreasing } from "./check.ts";

/*
 * Knot vectors: non-decreasing, every knot as often as its multiplicity. n + 1 control points of degree p go with
 * m + 1 = n + p + 2 knots u_0 … u_m; the parameter domain is [u_p, u_{n+1}]. At a knot of multiplicity s the curve is
 * C^{p−s}.
 */

/**
 * Demands a knot vector for `count` basis functions of a degree: right length, non-decreasing, no knot more than
 * degree + 1 times, a domain that is not empty.
 *
 * @throws RangeError naming the knot that is not as it should be.
 */
export function checkKnots(degree: number, knots: readonly number[], count: number): void {
  checkInteger("degree", degree, 0);
  checkNonDecreasing("knots", knots);
  if (knots.length !== count + degree + 1) {
    throw new RangeError(
      `knots: expected ${count + degree + 1} = ${count} control points + degree ${degree} + 1 knots, got ${knots.length}`,
    );
  }
  if (count < degree + 1) {
    throw new RangeError(
      `knots: expected at least 2·(degree + 1) = ${2 * degree + 2} knots, for degree + 1 control points, got ${knots.length}`,
    );
  }
  for (let i = 0; i + degree + 1 < knots.length; i++) {
    if (knots[i] === knots[i + degree + 1]) {
      throw new RangeError(
        `knots[${i}]: expected a knot at most degree + 1 = ${degree + 1} times, got ${knots[i]} more often`,
      );
    }
  }
  if (!(knots[degree]! < knots[count]!)) {
    throw new RangeError(
      `knots: expected a domain [knots[${degree}], knots[${count}]] that is not empty, got [${knots[degree]}, ${knots[count]}]`,
    );
  }
}

/**
 * Demands that a knot vector gives a connected curve: inside the domain no knot more often than `degree` times.
 *
 * @throws RangeError as `checkKnots`, and naming the knot at which the curve would be torn.
 */
export function checkCurveKnots(degree: number, knots: readonly number[], count: number): void {
  checkKnots(degree, knots, count);
  // A step function, degree 0, is torn at every knot by nature.
  if (degree === 0) return;
  const [a, b] = knotDomain(degree, knots);
  for (let i = 0; i + degree < knots.length; i++) {
    const t = knots[i]!;
    if (t > a && t < b && t === knots[i + degree]) {
      throw new RangeError(
        `knots[${i}]: expected an inner knot at most degree = ${degree} times, got ${t} more often; the curve would be torn there`,
      );
    }
  }
}

/** The parameter domain [u_p, u_{n+1}] of a knot vector. */
export function knotDomain(degree: number, knots: readonly number[]): readonly [number, number] {
  return [knots[degree]!, knots[knots.length - 1 - degree]!];
}

/** The distinct knots of the domain, ascending, both ends included: between two of them a spline is one polynomial. */
export function knotBreaks(degree: number, knots: readonly number[]): number[] {
  const [a, b] = knotDomain(degree, knots);
  return knots.filter((t, i) => t >= a && t <= b && t !== knots[i + 1]);
}

/** How often t occurs among the knots. */
export function multiplicity(knots: readonly number[], t: number): number {
  return knots.filter((knot) => knot === t).length;
}

/**
 * The knot span of t: the index k with u_k ≤ t < u_{k+1}, p ≤ k ≤ n, found by bisection.
 *
 * The right end of the domain belongs to its last non-empty span; parameters outside the domain to the span nearest to
 * them, whose polynomial is thus continued. The knots are taken as they are (see `checkKnots`).
 */
export function findSpan(degree: number, knots: readonly number[], t: number): number {
  let low = degree;
  let high = knots.length - 1 - degree;
  const [a, b] = [knots[low]!, knots[high]!];
  // Invariant: u_low ≤ t' < u_high (from the right) for t' = t moved into the domain; at its end u_low < b = u_high.
  const before = t >= b ? (knot: number) => knot < b : (knot: number) => knot <= Math.max(t, a);
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (before(knots[middle]!)) low = middle;
    else high = middle;
  }
  return low;
}

/**
 * A clamped knot vector on a domain [a, b] with evenly spaced inner knots: the curve begins in the first and ends in the last
 * control point, tangent to the control polygon.
 *
 * @throws RangeError if not a < b, the degree is not a whole number ≥ 0 or there are fewer than degree + 1 control
 * points.
 */
export function clampedKnots(
  degree: number,
  count: number,
  domain: readonly [number, number] = [0, 1],
): number[] {
  checkInteger("degree", degree, 0);
  checkInteger("count", count, degree + 1);
  checkInterval("domain", domain);
  const [a, b] = domain;
  const spans = count - degree;
  const breaks = Array.from({ length: spans + 1 }, (_, i) => a + ((b - a) * i) / spans);
  breaks[spans] = b;
  return [...new Array<number>(degree).fill(a), ...breaks, ...new Array<number>(degree).fill(b)];
}

/**
 * A uniform knot vector: whole numbers, simple, with the domain [0, count − degree]. The curve touches neither end of its
 * control polygon.
 *
 * @throws RangeError if the degree is not a whole number ≥ 0 or there are fewer than degree + 1 control points.
 */
export function uniformKnots(degree: number, count: number): number[] {
  checkInteger("degree", degree, 0);
  checkInteger("count", count, degree + 1);
  return Array.from({ length: count + degree + 1 }, (_, i) => i - degree);
}

/**
 * The data of a closed (periodic) uniform B-spline: uniform knots and the control points with the first `degree` of
 * them repeated at the end. The curve is C^{degree−1} where it closes.
 *
 * @throws RangeError if the degree is not a whole number ≥ 1 or there are fewer than degree control points.
 */
export function periodicControlPoints<T>(
  degree: number,
  controlPoints: readonly T[],
): { readonly knots: number[]; readonly controlPoints: T[] } {
  checkInteger("degree", degree, 1);
  checkInteger("controlPoints.length", controlPoints.length, degree);
  const wrapped = [...controlPoints, ...controlPoints.slice(0, degree)];
  return { knots: uniformKnots(degree, wrapped.length), controlPoints: wrapped };
}
