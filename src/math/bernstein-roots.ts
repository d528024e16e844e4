import { binomial } from "./bernstein.ts";
import { checkNumbers } from "./check.ts";
import { findRoot } from "./find-root.ts";

/** A zero of a function, and whether the function changes its sign there. */
export type Root = { readonly t: number; readonly signChange: boolean };

/** A value below this part of the largest coefficient counts as zero: a zero without change of sign, up to rounding. */
const relativeZero = 1e-11;

/**
 * All zeros in [0, 1] of the polynomial Σ coefficients[i] · B_i^n(t), ascending, each once whatever its multiplicity.
 *
 * Between two neighbouring zeros of its derivative (found in the same way, one degree lower) the polynomial is
 * monotone, so a change of sign encloses exactly one zero. A zero at 0 or 1 is reported without change of sign. A value
 * below 1e-11 of the largest coefficient counts as zero, so multiple zeros are found despite rounding; zeros
 * that lie so close together are reported as one. The zero polynomial gives no zeros.
 *
 * @throws RangeError if there is no coefficient or one is not finite.
 */
export function bernsteinRoots(coefficients: readonly number[]): Root[] {
  checkNumbers("coefficients", coefficients);
  return rootsOf(coefficients);
}

function rootsOf(coefficients: readonly number[]): Root[] {
  const n = coefficients.length - 1;
  const largest = Math.max(...coefficients.map(Math.abs));
  if (n === 0 || largest === 0) return [];
  const b = coefficients.map((c) => c / largest);
  const derivative = b.slice(1).map((c, i) => n * (c - b[i]!));
  const stops = [0, ...rootsOf(derivative).map((root) => root.t), 1].map((t) => {
    const value = evaluate(b, t);
    return { t, sign: Math.abs(value) <= relativeZero ? 0 : Math.sign(value) };
  });

  const roots: Root[] = [];
  let before = 0; // the last sign other than 0
  for (let i = 0; i < stops.length; i++) {
    const { t, sign } = stops[i]!;
    if (sign !== 0) {
      if (i > 0 && stops[i - 1]!.sign === -sign) {
        roots.push({ t: findRoot((x) => evaluate(b, x), stops[i - 1]!.t, t, 0), signChange: true });
      }
      before = sign;
      continue;
    }
    // A run of stops that count as zero is one zero, in its middle or at an end of [0, 1].
    const first = t;
    while (stops[i + 1]?.sign === 0) i++;
    const last = stops[i]!.t;
    const middle = first === 0 ? 0 : last === 1 ? 1 : (first + last) / 2;
    roots.push({ t: middle, signChange: before * (stops[i + 1]?.sign ?? 0) < 0 });
  }
  return roots;
}

/** De Casteljau's construction on numbers. */
function evaluate(coefficients: readonly number[], t: number): number {
  const b = [...coefficients];
  for (let r = b.length - 1; r > 0; r--) {
    for (let i = 0; i < r; i++) b[i] = (1 - t) * b[i]! + t * b[i + 1]!;
  }
  return b[0]!;
}

/** The Bernstein coefficients of the product of two polynomials on [0, 1], of degree n + m. */
export function bernsteinProduct(f: readonly number[], g: readonly number[]): number[] {
  checkNumbers("f", f);
  checkNumbers("g", g);
  const n = f.length - 1;
  const m = g.length - 1;
  return Array.from({ length: n + m + 1 }, (_, k) => {
    let sum = 0;
    for (let i = Math.max(0, k - m); i <= Math.min(n, k); i++) {
      sum += binomial(n, i) * binomial(m, k - i) * f[i]! * g[k - i]!;
    }
    return sum / binomial(n + m, k);
  });
}
