import { checkNumber, checkPositive } from "./check.ts";
import { gaussLegendre } from "./gauss-legendre.ts";

const rule = /* @__PURE__ */ gaussLegendre(16);

/** Bisection this deep reaches neighbouring doubles; it bounds the work at a point where the function is not smooth. */
const deepest = 50;

/**
 * The integral of f from a to b, with an error of about `accuracy` at most (absolute), but not below rounding, some
 * 1e-15 of the integral of |f|.
 *
 * Adaptive Gauss–Legendre quadrature: an interval is halved until the rule with 16 points agrees with itself on the two
 * halves. A kink costs some dozens of halvings. f must be finite on [a, b]; for a > b the result is negated.
 *
 * @throws RangeError if a or b is not finite or `accuracy` not positive.
 */
export function integrate(f: (t: number) => number, a: number, b: number, accuracy: number): number {
  checkNumber("a", a);
  checkNumber("b", b);
  checkPositive("accuracy", accuracy);
  const whole = gauss(f, a, b);
  return refine(f, a, b, whole, accuracy, 1e-15 * Math.abs(whole), deepest);
}

function refine(
  f: (t: number) => number,
  a: number,
  b: number,
  whole: number,
  accuracy: number,
  rounding: number,
  depth: number,
): number {
  const middle = a + (b - a) / 2;
  const left = gauss(f, a, middle);
  const right = gauss(f, middle, b);
  const error = Math.abs(left + right - whole);
  if (error <= accuracy || error <= rounding || depth === 0) return left + right;
  return (
    refine(f, a, middle, left, accuracy / 2, rounding, depth - 1) +
    refine(f, middle, b, right, accuracy / 2, rounding, depth - 1)
  );
}

function gauss(f: (t: number) => number, a: number, b: number): number {
  const half = (b - a) / 2;
  const middle = a + half;
  let sum = 0;
  for (let k = 0; k < rule.nodes.length; k++) sum += rule.weights[k]! * f(middle + half * rule.nodes[k]!);
  return half * sum;
}
