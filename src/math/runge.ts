/** Runge's function 1/(1 + x²), whose interpolating polynomials on equidistant nodes of [−5, 5] diverge. */
export function runge(x: number): number {
  return 1 / (1 + x * x);
}

/** The derivative −2x/(1 + x²)² of Runge's function. */
export function rungeDerivative(x: number): number {
  // Two divisions, so that a large x gives 0 and not ∞/∞.
  return ((-2 * x) / (1 + x * x)) * runge(x);
}
