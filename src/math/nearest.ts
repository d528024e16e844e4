import { bernsteinProduct, bernsteinRoots } from "./bernstein-roots.ts";
import { bezierPoint, hodograph } from "./bezier.ts";
import { checkInteger, checkPoint, checkPoints, checkPositive } from "./check.ts";
import type { Curve } from "./curve.ts";
import { distance, type Point, sub } from "./point.ts";

/** A point of a curve next to a given one. */
export type Nearest = { readonly t: number; readonly point: Point; readonly distance: number };

/**
 * The point of a curve nearest to `target`, with its parameter and distance; of equally near ones the first.
 *
 * The curve is sampled `samples` times in each smooth piece, and around every sample that is nearer than its neighbours the
 * distance is minimised until t is known to `accuracy` (as a parameter). A dip narrower than two samples may be missed; `bezierNearest` cannot miss one.
 *
 * @throws RangeError if `target` has another dimension than the curve, `accuracy` is not positive or `samples` is not a
 * whole number ≥ 2.
 */
export function nearest(curve: Curve, target: Point, accuracy: number, samples = 64): Nearest {
  checkPoint("target", target, curve.dimension);
  checkPositive("accuracy", accuracy);
  checkInteger("samples", samples, 2);
  const at = (t: number): Nearest => {
    const point = curve.point(t);
    return { t, point, distance: distance(point, target) };
  };
  const [a, b] = curve.domain;
  const stops = [a, ...(curve.breaks ?? []), b];
  const candidates = stops.slice(1).flatMap((stop, i) => {
    const start = stops[i]!;
    return Array.from({ length: samples }, (_, k) => at(start + ((stop - start) * k) / samples));
  });
  candidates.push(at(b));
  let best = candidates[0]!;
  candidates.forEach((here, i) => {
    const before = candidates[i - 1] ?? here;
    const after = candidates[i + 1] ?? here;
    if (here.distance > before.distance || here.distance > after.distance) return;
    const refined = minimum(at, before.t, after.t, accuracy);
    for (const found of [here, refined]) if (found.distance < best.distance) best = found;
  });
  return best;
}

const golden = (Math.sqrt(5) - 1) / 2;

/** Golden section search between a and b. */
function minimum(at: (t: number) => Nearest, a: number, b: number, accuracy: number): Nearest {
  let low = at(b - golden * (b - a));
  let high = at(a + golden * (b - a));
  while (b - a > accuracy && low.t > a && high.t < b && low.t < high.t) {
    if (low.distance <= high.distance) {
      b = high.t;
      high = low;
      low = at(b - golden * (b - a));
    } else {
      a = low.t;
      low = high;
      high = at(a + golden * (b - a));
    }
  }
  return low.distance <= high.distance ? low : high;
}

/**
 * The point of a Bézier curve nearest to `target`, with its parameter in [0, 1] and distance; of equally near ones the
 * first.
 *
 * Exact up to rounding: the candidates are the ends and all zeros of (p(t) − target) · p′(t), a polynomial of degree
 * 2n − 1.
 *
 * @throws RangeError if there is no control point, dimensions differ or a number is not finite.
 */
export function bezierNearest(controlPoints: readonly Point[], target: Point): Nearest {
  const dimension = checkPoints("controlPoints", controlPoints);
  checkPoint("target", target, dimension);
  const toCurve = controlPoints.map((point) => sub(point, target));
  const derivative = hodograph(controlPoints);
  const products = target.map((_, axis) =>
    bernsteinProduct(
      toCurve.map((p) => p[axis]!),
      derivative.map((p) => p[axis]!),
    ),
  );
  const sum = products[0]!.map((_, k) => products.reduce((total, product) => total + product[k]!, 0));
  let best: Nearest | undefined;
  for (const t of [0, ...bernsteinRoots(sum).map((root) => root.t), 1]) {
    const point = bezierPoint(controlPoints, t);
    const here = { t, point, distance: distance(point, target) };
    if (!best || here.distance < best.distance) best = here;
  }
  return best!;
}
