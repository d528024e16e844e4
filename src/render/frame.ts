import type { Label } from "../scene/label.ts";
import type { Role } from "../scene/marks.ts";
import type { View, ViewTransform } from "../scene/view.ts";
import { formatNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import type { Primitive } from "./primitives.ts";
import { setLabel } from "./set-label.ts";
import { SIZE } from "./sizes.ts";
import { ticks } from "./ticks.ts";

/** The least distance of neighbouring grid lines and axis numbers, in pixels. */
const SPACING = { grid: 44, x: 52, y: 30 };

/** The grid and the axes of a window, with numbers as the reader writes them. */
export function frame(view: View, transform: ViewTransform, lang: Lang): Primitive[] {
  const list: Primitive[] = [];
  if (view.grid) list.push(grid(view, transform));
  if (view.axes) list.push(...axes(view.axes, transform, lang));
  return list;
}

function lines(role: Role, ends: readonly (readonly [number, number, number, number])[]): Primitive {
  const steps = ends.flatMap(([x0, y0, x1, y1]) => [["M", [x0, y0]] as const, ["L", [x1, y1]] as const]);
  return { kind: "path", role, part: "line", steps };
}

/** The middle of a pixel, where a line one pixel wide is sharp. */
const sharp = (x: number) => Math.floor(x) + 0.5;

function grid(view: View, { box, x, y, scale, toPixel }: ViewTransform): Primitive {
  const right = box.left + box.width;
  const bottom = box.top + box.height;
  // With numbers, every line has one.
  const across = ticks(x, scale[0]!, view.axes ? SPACING.x : SPACING.grid);
  const up = ticks(y, scale[1]!, view.axes ? SPACING.y : SPACING.grid);
  const upright = across.values.map((value) => sharp(toPixel([value, 0])[0]));
  const level = up.values.map((value) => sharp(toPixel([0, value])[1]));
  return lines("grid", [
    ...upright.map((at) => [at, box.top, at, bottom] as const),
    ...level.map((at) => [box.left, at, right, at] as const),
  ]);
}

/**
 * The axes: lines through the origin, or along the edge where the origin is out of sight, with the numbers
 * outside the window. Where only one axis has a name, only that one is drawn.
 */
function axes(
  names: { readonly x?: Label; readonly y?: Label },
  { box, x, y, scale, toPixel }: ViewTransform,
  lang: Lang,
): Primitive[] {
  const right = box.left + box.width;
  const bottom = box.top + box.height;
  const [zeroX, zeroY] = toPixel([0, 0]);
  const axisX = sharp(x[0] <= 0 && x[1] >= 0 ? zeroX : box.left);
  const axisY = sharp(y[0] <= 0 && y[1] >= 0 ? zeroY : bottom);
  const list: Primitive[] = [];
  if (names.x || !names.y) {
    const { values, digits } = ticks(x, scale[0]!, SPACING.x);
    list.push(lines("axis", [[box.left, axisY, right, axisY]]));
    for (const value of values) {
      const at = [toPixel([value, 0])[0], bottom + 8 + SIZE.axisNumber * 0.72];
      list.push(text(at, "middle", formatNumber(value, lang, digits)));
    }
    if (names.x) list.push(axisName(names.x, lang, [right + 4, axisY + 4]));
  }
  if (names.y || !names.x) {
    const { values, digits } = ticks(y, scale[1]!, SPACING.y);
    list.push(lines("axis", [[axisX, box.top, axisX, bottom]]));
    for (const value of values) {
      const at = [box.left - 7, toPixel([0, value])[1] + SIZE.axisNumber * 0.34];
      list.push(text(at, "end", formatNumber(value, lang, digits)));
    }
    if (names.y) list.push(axisName(names.y, lang, [axisX + 6, box.top + 6]));
  }
  return list;
}

function text(at: readonly number[], anchor: "middle" | "end", number: string): Primitive {
  const runs = [{ text: number, font: "text", size: SIZE.axisNumber, dx: 0, dy: 0 }] as const;
  return { kind: "text", role: "axis", part: "plain", at, anchor, runs };
}

function axisName(label: Label, lang: Lang, at: readonly number[]): Primitive {
  const { runs } = setLabel(label, lang, SIZE.axisName);
  return { kind: "text", role: "axis", part: "text", at, anchor: "start", runs };
}
