import type { PathStep, XY } from "./marks.ts";

/**
 * The drawing of any smooth curve: between neighbouring parameters of `stops` a cubic with the curve's own end points
 * and end derivatives. Exact for curves of degree ≤ 3; otherwise the error falls with the fourth power of the spacing.
 */
export function hermiteSteps(
  at: (t: number) => XY,
  derivative: (t: number) => XY,
  stops: readonly number[],
): PathStep[] {
  const steps: PathStep[] = [["M", at(stops[0]!)]];
  for (let k = 1; k < stops.length; k++) {
    const [from, to] = [stops[k - 1]!, stops[k]!];
    const third = (to - from) / 3;
    const [start, end] = [at(from), at(to)];
    const [leave, arrive] = [derivative(from), derivative(to)];
    const inner = (point: XY, vector: XY, sign: number) =>
      point.map((x, axis) => x + sign * third * vector[axis]!);
    steps.push(["C", inner(start, leave, 1), inner(end, arrive, -1), end]);
  }
  return steps;
}

/** `count` + 1 parameters at equal distances from a to b. */
export function evenly(a: number, b: number, count: number): number[] {
  return Array.from({ length: count + 1 }, (_, k) => a + ((b - a) * k) / count);
}
