import { label, polyline, region } from "./draw.ts";
import type { Label } from "./label.ts";
import type { Mark } from "./marks.ts";
import type { View } from "./view.ts";

/** Share of the bar's width that separates two weights. */
const GAP = 0.003;

/** Share of the width that a number needs, on a telephone too; one with a minus sign needs more. */
const ROOM = { plain: 0.1, minus: 0.13 };

/** The window of a bar: as wide as the figure, a line of text high. */
export function barView(view: Pick<View, "label">): View {
  return { ...view, x: [0, 1], y: [0, 1], fit: "stretch", height: 0.052, narrowHeight: 0.1 };
}

/**
 * Weights side by side: the length of piece i is its share of all weights. Negative weights are hollow. Pieces long
 * enough carry their number. Draws into a view of [0, 1] × [0, 1].
 */
export function weightBar(weights: readonly number[], numberOf: (weight: number) => Label): Mark[] {
  const whole = weights.reduce((sum, weight) => sum + Math.abs(weight), 0);
  let end = 0;
  return weights.flatMap((weight, index): Mark[] => {
    const start = end;
    end += Math.abs(weight) / whole;
    const [left, right] = [start + (start > 0 ? GAP / 2 : 0), end - (end < 1 ? GAP / 2 : 0)];
    if (!(right > left)) return [];
    const extra = { index, name: `weights.${index}` };
    const corners = [
      [left, 0],
      [right, 0],
      [right, 1],
      [left, 1],
    ];
    const hollow = weight < 0;
    const piece = hollow
      ? polyline(`piece-${index}`, "weight", [...corners, corners[0]!], extra)
      : region(`piece-${index}`, "weight", corners, extra);
    if (right - left < ROOM[hollow ? "minus" : "plain"]) return [piece];
    const role = hollow ? "curve" : "weight";
    const middle = [(left + right) / 2, 0.5];
    return [piece, label(`number-${index}`, role, middle, numberOf(weight), { ...extra, place: "centre" })];
  });
}
