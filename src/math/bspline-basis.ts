import { checkInteger, checkNumber } from "./check.ts";
import { checkKnots, findSpan, knotDomain } from "./knots.ts";

/**
 * Cox and de Boor's recursion: all levels of B-spline basis functions at t, level q holding every N_i^q(t).
 *
 * N_i^0 is 1 on its span and 0 elsewhere; N_i^q(t) = (t − u_i)/(u_{i+q} − u_i)·N_i^{q−1}(t)
 * + (u_{i+q+1} − t)/(u_{i+q+1} − u_{i+1})·N_{i+1}^{q−1}(t), a fraction with denominator 0 counting as 0. Each level
 * adds up to 1 on its part of the domain. At a knot the functions are taken from the right, at the right end of the
 * domain from the left. Outside the domain (unclamped knots) the functions are those of the whole knot vector, which
 * no longer add up to 1; outside the knots all are 0.
 * After M. G. Cox, The numerical evaluation of B-splines, and C. de Boor, On calculating with B-splines.
 *
 * @throws RangeError for bad knots (see `checkKnots`) or a number that is not finite.
 */
export function coxDeBoor(degree: number, knots: readonly number[], t: number): number[][] {
  checkKnots(degree, knots, knots.length - degree - 1);
  checkNumber("t", t);
  return recursion(degree, knots, t);
}

/**
 * The B-spline basis functions N_0^p … N_n^p at t, or their r-th derivatives.
 *
 * @throws RangeError as `coxDeBoor`, and if r is not a whole number ≥ 0.
 */
export function bsplineBasis(degree: number, knots: readonly number[], t: number, r = 0): number[] {
  checkKnots(degree, knots, knots.length - degree - 1);
  checkNumber("t", t);
  checkInteger("r", r, 0);
  if (r > degree) return new Array<number>(knots.length - degree - 1).fill(0);
  let values = recursion(degree - r, knots, t, degree)[degree - r]!;
  // d/dt N_i^q = q·[N_i^{q−1}/(u_{i+q} − u_i) − N_{i+1}^{q−1}/(u_{i+q+1} − u_{i+1})], r times.
  for (let q = degree - r + 1; q <= degree; q++) {
    values = values
      .slice(1)
      .map(
        (next, i) =>
          q * (over(values[i]!, knots[i + q]! - knots[i]!) - over(next, knots[i + q + 1]! - knots[i + 1]!)),
      );
  }
  return values;
}

/** Levels 0 … `top` of the recursion; the span is that of the B-spline of degree `degree`. */
function recursion(top: number, knots: readonly number[], t: number, degree = top): number[][] {
  const span = spanOnKnots(degree, knots, t);
  const levels: number[][] = [knots.slice(1).map((_, i) => (i === span ? 1 : 0))];
  for (let q = 1; q <= top; q++) {
    const n = levels[q - 1]!;
    const level: number[] = [];
    for (let i = 0; i + 1 < n.length; i++) {
      const rising = over((t - knots[i]!) * n[i]!, knots[i + q]! - knots[i]!);
      const falling = over((knots[i + q + 1]! - t) * n[i + 1]!, knots[i + q + 1]! - knots[i + 1]!);
      level.push(rising + falling);
    }
    levels.push(level);
  }
  return levels;
}

/** The span of t within the domain or, outside it, within the whole knot vector; −1 outside all knots. */
function spanOnKnots(degree: number, knots: readonly number[], t: number): number {
  const [a, b] = knotDomain(degree, knots);
  if (t >= a && t <= b) return findSpan(degree, knots, t);
  return t >= knots[0]! && t <= knots.at(-1)! ? findSpan(0, knots, t) : -1;
}

/** The quotient, 0 for a denominator 0: a basis function without support is 0. */
function over(numerator: number, denominator: number): number {
  return denominator === 0 ? 0 : numerator / denominator;
}
