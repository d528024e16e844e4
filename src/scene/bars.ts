import { label, point, polyline, region } from "./draw.ts";
import type { Label } from "./label.ts";
import type { Mark } from "./marks.ts";
import type { View } from "./view.ts";

/** Share of the bar's width that separates two weights. */
const GAP = 0.003;

/** The window of a bar: as wide as the figure, a line of text high. */
export function barView(view: Pick<View, "label">): View {
  return { ...view, x: [0, 1], y: [0, 1], fit: "stretch", height: 0.052, narrowHeight: 0.1 };
}

/**
 * Weights that add up to 1, side by side: the length of piece i is its weight. Pieces long enough carry their number.
 * Draws into a view of [0, 1] × [0, 1].
 */
export function weightBar(weights: readonly number[], numberOf: (weight: number) => Label): Mark[] {
  let end = 0;
  return weights.flatMap((weight, index): Mark[] => {
    const start = end;
    end += weight;
    const [left, right] = [start + (start > 0 ? GAP / 2 : 0), end - (end < 1 ? GAP / 2 : 0)];
    if (right - left <= 0) return [];
    const name = `weights.${index}`;
    const corners = [
      [left, 0],
      [right, 0],
      [right, 1],
      [left, 1],
    ];
    const piece = region(`piece-${index}`, "weight", corners, { index, name });
    if (right - left < 0.1) return [piece];
    const middle = [(left + right) / 2, 0.5];
    return [
      piece,
      label(`number-${index}`, "weight", middle, numberOf(weight), { index, name, place: "centre" }),
    ];
  });
}

/** The parameter interval [0, 1] with the place t in it: the domain, beside its image. */
export function parameterBar(t: number): Mark[] {
  const at = (x: number) => [x, 0.5];
  return [
    polyline("domain", "axis", [at(0), at(1)]),
    polyline("passed", "curve", [at(0), at(t)]),
    point("t", "curve", at(t), { name: "t" }),
  ];
}
