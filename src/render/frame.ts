import type { Label } from "../scene/label.ts";
import { shownAxes } from "../scene/layout.ts";
import type { Role } from "../scene/marks.ts";
import type { View, ViewTransform } from "../scene/view.ts";
import { formatNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import type { Primitive } from "./primitives.ts";
import { setLabel } from "./set-label.ts";
import { SIZE } from "./sizes.ts";
import { ticks } from "./ticks.ts";

/** The least distance of neighbouring grid lines and axis numbers, in pixels. */
const SPACING = { grid: 44, x: 52, y: 36 };

/** The grid and the axes of a window, with numbers as the reader writes them. */
export function frame(view: View, transform: ViewTransform, lang: Lang): Primitive[] {
  const list: Primitive[] = [];
  if (view.grid) list.push(grid(view, transform));
  if (view.axes) list.push(...axes(view, transform, lang));
  return list;
}

/** A straight line: x and y of its ends. */
type Ends = readonly [number, number, number, number];

function lines(role: Role, ends: readonly Ends[]): Primitive {
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
 * outside the window.
 */
function axes(view: View, { box, x, y, scale, toPixel }: ViewTransform, lang: Lang): Primitive[] {
  const right = box.left + box.width;
  const bottom = box.top + box.height;
  const [zeroX, zeroY] = toPixel([0, 0]);
  const axisX = sharp(x[0] <= 0 && x[1] >= 0 ? zeroX : box.left);
  const axisY = sharp(y[0] <= 0 && y[1] >= 0 ? zeroY : bottom);
  const shown = shownAxes(view);
  const list: Primitive[] = [];
  // Where no grid leads to the numbers, small strokes on the axes do.
  const stroke = view.grid ? 0 : 3;
  if (shown.x) {
    const { values, digits } = ticks(x, scale[0]!, SPACING.x);
    const places = values.map((value) => toPixel([value, 0])[0]);
    const strokes =
      stroke > 0 ? places.map((at): Ends => [sharp(at), axisY - stroke, sharp(at), axisY + stroke]) : [];
    list.push(lines("axis", [[box.left, axisY, right, axisY], ...strokes]));
    const spots = values.map((value, i) => ({ value, dx: places[i]!, dy: bottom + 20 }));
    list.push(numbers(spots, "middle", lang, digits));
    if (view.axes?.x?.base) list.push(nameOfX(view.axes.x, lang, right, axisY));
  }
  if (shown.y) {
    const { values, digits } = ticks(y, scale[1]!, SPACING.y);
    const places = values.map((value) => toPixel([0, value])[1]);
    const strokes =
      stroke > 0 ? places.map((at): Ends => [axisX - stroke, sharp(at), axisX + stroke, sharp(at)]) : [];
    list.push(lines("axis", [[axisX, box.top, axisX, bottom], ...strokes]));
    const spots = values.map((value, i) => ({
      value,
      dx: box.left - 8,
      dy: places[i]! + SIZE.axisNumber * 0.34,
    }));
    list.push(numbers(spots, "end", lang, digits));
    if (view.axes?.y?.base) list.push(nameOfY(view.axes.y, lang, axisX, box.top));
  }
  return list;
}

/** The numbers of an axis, each at its own place. */
function numbers(
  spots: readonly { readonly value: number; readonly dx: number; readonly dy: number }[],
  anchor: "middle" | "end",
  lang: Lang,
  digits: number,
): Primitive {
  const runs = spots.map(({ value, dx, dy }) => {
    const text = formatNumber(value, lang, digits);
    return { text, font: "text", size: SIZE.axisNumber, dx, dy } as const;
  });
  return { kind: "text", role: "axis", part: "plain", at: [0, 0], anchor, runs };
}

/** At the end of the axis, or above it where the name is too long for the margin. */
function nameOfX(label: Label, lang: Lang, right: number, axis: number): Primitive {
  const { runs, width } = setLabel(label, lang, SIZE.axisName);
  const short = width <= 9;
  const at = short ? [right + 4, axis + 4] : [right - width, axis - 7];
  return { kind: "text", role: "axis", part: short ? "plain" : "text", at, anchor: "start", runs };
}

/** Above the end of the axis. */
function nameOfY(label: Label, lang: Lang, axis: number, top: number): Primitive {
  const { runs, width } = setLabel(label, lang, SIZE.axisName);
  const at = [Math.max(2, axis - width / 2), top - 10];
  return { kind: "text", role: "axis", part: "plain", at, anchor: "start", runs };
}
