import { bezierDerivative } from "./bezier.ts";
import { checkPoints } from "./check.ts";
import { curvatureVectorOf } from "./curvature.ts";
import { bezierCurve } from "./curve.ts";
import { add, distance, dot, type Point, scale, sub } from "./point.ts";
import { isRegular, unitTangent } from "./tangent.ts";

/** The continuity to repair a joint to. */
export type JointClass = "C0" | "G1" | "C1" | "G2" | "C2";

/**
 * New control points for `b`, so that it continues the Bézier curve `a` (both over [0, 1]) with the continuity `to`.
 *
 * Only the first points of b change, and as little as the class asks for: b_0 moves to the end of a; for G¹ b_1 is
 * turned about it into the direction of a's end tangent and keeps its distance (that of a's last leg if it had none); for C¹
 * b_1 = b_0 + (n/m)·(a_n − a_{n−1}); for C² also b_2, from equal second derivatives; for G² b_1 as for G¹, and b_2
 * moves across the tangent until the curvature vectors agree.
 *
 * `null` if it cannot be done: a stands still at its end (G¹) or its end derivative vanishes (G², and C¹, C², which
 * would leave a joint that is not regular), or b has fewer control points than the class fixes.
 *
 * @throws RangeError if there is no control point, dimensions differ or a number is not finite.
 */
export function repairJoint(a: readonly Point[], b: readonly Point[], to: JointClass): Point[] | null {
  const dimension = checkPoints("a", a);
  checkPoints("b", b, 1, dimension);
  const fixed = { C0: 1, G1: 2, C1: 2, G2: 3, C2: 3 }[to];
  if (b.length < fixed) return null;
  const m = b.length - 1;
  const end = a.at(-1)!;
  const rest = b.slice(fixed);
  if (to === "C0") return [end, ...rest];

  const curve = bezierCurve(a);
  const tangent = unitTangent(curve, 1);
  const d1 = bezierDerivative(a, 1);
  const d2 = bezierDerivative(a, 1, 2);
  const regular = isRegular(curve, 1);
  if (!tangent || (to !== "G1" && !regular)) return null;

  if (to === "C1" || to === "C2") {
    const next = add(end, scale(d1, 1 / m));
    if (to === "C1") return [end, next, ...rest];
    // b″ = m(m − 1)·(b_2 − 2b_1 + b_0) = a″
    const bend = scale(d2, 1 / (m * (m - 1)));
    return [end, next, add(sub(scale(next, 2), end), bend), ...rest];
  }

  const leg = distance(b[1]!, b[0]!) || distance(end, a.findLast((p) => distance(p, end) > 0)!);
  const next = add(end, scale(tangent, leg));
  if (to === "G1") return [end, next, ...rest];
  // Curvature vector = (m − 1)/m · (part of b_2 − b_1 across the tangent) / leg².
  const across = scale(curvatureVectorOf(d1, d2), (m / (m - 1)) * leg * leg);
  const along = scale(tangent, dot(sub(b[2]!, end), tangent));
  return [end, next, add(end, add(along, across)), ...rest];
}
