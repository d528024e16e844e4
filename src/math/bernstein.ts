import { checkInteger, checkNumber } from "./check.ts";

/** The binomial coefficient "n over k" for whole n ≥ 0; 0 for k < 0 and for k > n. */
export function binomial(n: number, k: number): number {
  checkInteger("n", n, 0);
  if (k < 0 || k > n) return 0;
  let result = 1;
  // After step j the result is the whole number "n over j" as long as doubles can hold it.
  for (let j = 1; j <= Math.min(k, n - k); j++) result = (result * (n + 1 - j)) / j;
  return Math.round(result);
}

/**
 * The Bernstein polynomial B_i^n(t) = (n over i) · t^i · (1 − t)^(n − i).
 *
 * Any finite t; on [0, 1] the values lie in [0, 1]. By convention B_i^n = 0 for i < 0 and for i > n. The relative
 * error is a small multiple of n · 2⁻⁵³; high degrees neither overflow nor give NaN on [0, 1].
 *
 * @throws RangeError if n is not a whole number ≥ 0, i not whole or t not finite.
 */
export function bernstein(n: number, i: number, t: number): number {
  checkInteger("n", n, 0);
  checkInteger("i", i, Number.MIN_SAFE_INTEGER);
  checkNumber("t", t);
  if (i < 0 || i > n) return 0;
  let product = 1;
  let left = n - i; // factors (1 − t) not yet multiplied in
  for (let j = 1; j <= i; j++) {
    product *= ((n - i + j) / j) * t;
    // Taking factors alternately keeps the product in range where the binomial coefficient would overflow.
    for (; left > 0 && Math.abs(product) > 1; left--) product *= 1 - t;
  }
  return product * (1 - t) ** left;
}

/** All Bernstein polynomials of degree n at t: [B_0^n(t), …, B_n^n(t)]; they add up to 1. */
export function bernsteinAll(n: number, t: number): number[] {
  checkInteger("n", n, 0);
  return Array.from({ length: n + 1 }, (_, i) => bernstein(n, i, t));
}

/**
 * The r-th derivative of B_i^n at t, by d/dt B_i^n = n · (B_{i−1}^{n−1} − B_i^{n−1}) taken r times.
 *
 * @throws RangeError if n or r is not a whole number ≥ 0, i not whole or t not finite.
 */
export function bernsteinDerivative(n: number, i: number, t: number, r = 1): number {
  checkInteger("r", r, 0);
  if (r === 0) return bernstein(n, i, t);
  if (n === 0) return 0;
  return n * (bernsteinDerivative(n - 1, i - 1, t, r - 1) - bernsteinDerivative(n - 1, i, t, r - 1));
}
