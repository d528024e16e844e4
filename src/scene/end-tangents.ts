import { hodograph } from "../math/index.ts";
import { arrow, label, polyline } from "./draw.ts";
import type { Mark, XY } from "./marks.ts";

/**
 * The derivatives at both ends of a Bézier curve of degree ≥ 1, as arrows of their true length from c_0 and c_n.
 *
 * Where a derivative vanishes (c_1 = c_0, say), a dashed line to the first control point that differs shows the tangent.
 */
export function endTangents(controlPoints: readonly XY[]): Mark[] {
  const derivatives = hodograph(controlPoints);
  return [
    ...tangentAt("0", controlPoints, derivatives[0]!),
    ...tangentAt("1", [...controlPoints].reverse(), derivatives.at(-1)!),
  ];
}

function tangentAt(end: "0" | "1", outward: readonly XY[], derivative: XY): Mark[] {
  const from = outward[0]!;
  const name = `derivative-${end}`;
  if (derivative.some((x) => x !== 0)) {
    const tip = from.map((x, k) => x + derivative[k]!);
    return [
      arrow(name, "tangent", from, tip, { name }),
      label(
        `${name}-label`,
        "tangent",
        tip,
        { base: "p", prime: 1, args: [Number(end)] },
        { toward: derivative },
      ),
    ];
  }
  const next = outward.find((point) => point.some((x, k) => x !== from[k]));
  return next ? [polyline(name, "reference", [from, next], { name })] : [];
}
