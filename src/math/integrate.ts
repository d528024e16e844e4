import { checkNumber, checkPositive } from "./check.ts";
import { gaussLobatto } from "./gauss-lobatto.ts";

const rule = /* @__PURE__ */ gaussLobatto(13);

/**
 * The integral of f from a to b, with an error of about `accuracy` at most (absolute), but not below rounding, some
 * 1e-15 of the integral.
 *
 * Adaptive Gauss–Lobatto quadrature: an interval is halved until the rule with 13 points agrees with itself on the two
 * halves, and each half again with its own halves, since one agreement may be chance. The rule looks at both ends, so
 * that a kink cannot hide beside them. A kink costs some dozens of halvings. f must be finite on [a, b]; for a > b the result is negated.
 *
 * @throws RangeError if a or b is not finite or `accuracy` not positive.
 */
export function integrate(f: (t: number) => number, a: number, b: number, accuracy: number): number {
  checkNumber("a", a);
  checkNumber("b", b);
  checkPositive("accuracy", accuracy);
  const whole = quadrature(f, a, b);
  const rounding = 1e-15 * Math.abs(whole);

  const refine = (from: number, to: number, coarse: number, allowed: number, agreed: boolean): number => {
    const middle = from + (to - from) / 2;
    const left = quadrature(f, from, middle);
    const right = quadrature(f, middle, to);
    const agrees = Math.abs(left + right - coarse) <= Math.max(allowed, rounding);
    if (agrees && agreed) return left + right;
    return refine(from, middle, left, allowed / 2, agrees) + refine(middle, to, right, allowed / 2, agrees);
  };
  return refine(a, b, whole, accuracy, false);
}

function quadrature(f: (t: number) => number, a: number, b: number): number {
  const half = (b - a) / 2;
  const middle = a + half;
  let sum = 0;
  for (let k = 0; k < rule.nodes.length; k++) sum += rule.weights[k]! * f(middle + half * rule.nodes[k]!);
  return half * sum;
}
