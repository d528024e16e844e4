import { checkAscending, checkPoint, checkPoints, checkSameLength } from "./check.ts";
import { add, type Point, scale, sub } from "./point.ts";
import type { TridiagonalSystem } from "./tridiagonal.ts";

/**
 * What a cubic spline does at its ends, beyond being C² inside:
 * - `clamped`: the first derivatives are given,
 * - `natural`: the second derivatives are 0, as of a lath that is free beyond the last pins,
 * - `notAKnot`: the third derivative is continuous at the second and the last but one node,
 * - `periodic`: first and last point are equal, and so are the first and second derivatives there.
 */
export type SplineEnd =
  | { readonly type: "clamped"; readonly start: Point; readonly end: Point }
  | { readonly type: "natural" }
  | { readonly type: "notAKnot" }
  | { readonly type: "periodic" };

/**
 * The tridiagonal system for the tangents m_0 … m_n of a cubic spline, from the continuity of the second derivative:
 *
 * h_r·m_{r−1} + 2(h_{r−1} + h_r)·m_r + h_{r−1}·m_{r+1} = 3·[h_r/h_{r−1}·(P_r − P_{r−1}) + h_{r−1}/h_r·(P_{r+1} − P_r)],
 * r = 1 … n − 1, h_r = t_{r+1} − t_r (uniform, h = 1: m_{r−1} + 4m_r + m_{r+1} = 3(P_{r+1} − P_{r−1})), and one
 * equation for each end. Periodic: the unknowns are m_0 … m_{n−1} and the system is cyclic (see `TridiagonalSystem`).
 * Two points: natural and not-a-knot give the straight line. Three points: not-a-knot gives the parabola.
 *
 * @throws RangeError if there are fewer than two nodes, the nodes do not ascend, the lists do not fit, dimensions
 * differ, a number is not finite, the end condition is unknown, or a periodic spline's last point is not its first.
 */
export function splineSystem(
  nodes: readonly number[],
  points: readonly Point[],
  end: SplineEnd,
): TridiagonalSystem {
  checkAscending("nodes", nodes, 2);
  const dimension = checkPoints("points", points);
  checkSameLength("points", points, "nodes", nodes);
  const n = points.length - 1;
  const h = nodes.slice(1).map((t, r) => t - nodes[r]!);
  const legs = points.slice(1).map((point, r) => sub(point, points[r]!));

  /** The equation that joins the segments `left` and `right` in C² at their common node. */
  const joint = (left: number, right: number): Equation => [
    h[right]!,
    2 * (h[left]! + h[right]!),
    h[left]!,
    add(scale(legs[left]!, 3 * (h[right]! / h[left]!)), scale(legs[right]!, 3 * (h[left]! / h[right]!))),
  ];
  const inner = legs.slice(1).map((_, i) => joint(i, i + 1));

  switch (end.type) {
    case "clamped":
      checkPoint("end.start", end.start, dimension);
      checkPoint("end.end", end.end, dimension);
      return assemble([[0, 1, 0, end.start], ...inner, [0, 1, 0, end.end]]);
    case "natural":
      return assemble([
        [0, 2, 1, scale(legs[0]!, 3 / h[0]!)],
        ...inner,
        [1, 2, 0, scale(legs[n - 1]!, 3 / h[n - 1]!)],
      ]);
    case "notAKnot": {
      const [first, last] = notAKnotEnds(h, legs);
      return assemble([first, ...inner, last]);
    }
    case "periodic": {
      const gap = points[n]!.findIndex((x, axis) => x !== points[0]![axis]);
      if (gap >= 0) {
        throw new RangeError(
          `points[${n}][${gap}]: expected ${points[0]![gap]} as in points[0], since the spline is periodic, got ${points[n]![gap]}`,
        );
      }
      return assemble([joint(n - 1, 0), ...inner]);
    }
    default:
      throw new RangeError(
        `end.type: expected clamped, natural, notAKnot or periodic, got "${(end as { type: string }).type}"`,
      );
  }
}

/** below · m[r−1] + diagonal · m[r] + above · m[r+1] = right. */
type Equation = readonly [below: number, diagonal: number, above: number, right: Point];

function assemble(equations: readonly Equation[]): TridiagonalSystem {
  return {
    below: equations.map(([below]) => below),
    diagonal: equations.map(([, diagonal]) => diagonal),
    above: equations.map(([, , above]) => above),
    right: equations.map(([, , , right]) => right),
  };
}

/**
 * Equal third derivatives at the second node, with m_2 removed by the equation of that node:
 * h_1·m_0 + (h_0 + h_1)·m_1 = [(3h_0 + 2h_1)·h_1·δ_0 + h_0²·δ_1]/(h_0 + h_1), δ_r the slope of leg r; mirrored at the
 * other end.
 */
function notAKnotEnds(h: readonly number[], legs: readonly Point[]): [Equation, Equation] {
  const n = h.length;
  const slope = legs.map((leg, r) => scale(leg, 1 / h[r]!));
  // One leg: the straight line. Two legs: both conditions are the same, so one parabola through all three points.
  if (n === 1)
    return [
      [0, 1, 0, slope[0]!],
      [0, 1, 0, slope[0]!],
    ];
  if (n === 2)
    return [
      [0, 1, 1, scale(slope[0]!, 2)],
      [1, 1, 0, scale(slope[1]!, 2)],
    ];
  const equation = (near: number, next: number): readonly [number, number, Point] => {
    const [h0, h1] = [h[near]!, h[next]!];
    const right = add(
      scale(slope[near]!, ((3 * h0 + 2 * h1) * h1) / (h0 + h1)),
      scale(slope[next]!, (h0 * h0) / (h0 + h1)),
    );
    return [h1, h0 + h1, right];
  };
  const [d0, a0, right0] = equation(0, 1);
  const [dn, bn, rightN] = equation(n - 1, n - 2);
  return [
    [0, d0, a0, right0],
    [bn, dn, 0, rightN],
  ];
}
