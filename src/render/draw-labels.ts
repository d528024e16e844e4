import type { LabelMark, Mark, PathStep } from "../scene/marks.ts";
import type { Box } from "../scene/view.ts";
import type { Lang } from "../words/words.ts";
import type { LabelRequest } from "./label-request.ts";
import { placeLabels } from "./place-labels.ts";
import { type SetText, setLabel } from "./set-label.ts";
import { base, inWindow, isLit, type Sheet } from "./sheet.ts";

/** Lettering may stand a little outside the window, but not on the numbers of an axis. */
const MARGIN = 4;

/** Sets the lettering of a window, once everything that it must not cover is there. */
export function drawLabels(sheet: Sheet, lang: Lang, marks: readonly Mark[]): void {
  const { transform, obstacles, primitives } = sheet;
  // Lettering lights up only where there is no mark of its name that does.
  const shown = new Set(marks.filter((mark) => mark.kind !== "label").map((mark) => mark.name));
  const { left, top, width, height } = transform.box;
  const bounds: Box = {
    left: left - MARGIN,
    top: top - MARGIN,
    width: width + 2 * MARGIN,
    height: height + 2 * MARGIN,
  };
  const seen = sheet.labels
    .map((mark) => ({ mark, at: transform.toPixel(mark.at), text: setLabel(mark.label, lang) }))
    .filter(({ mark, at, text }) => inWindow(at, transform.box) && fits(mark, at, text, sheet));
  const requests = seen.map(({ mark, at, text }): LabelRequest => {
    const toward = mark.toward && [
      mark.toward[0]! * transform.scale[0]!,
      -mark.toward[1]! * transform.scale[1]!,
    ];
    return {
      at,
      width: text.width,
      height: text.ascent + text.descent,
      clear: taken(at, sheet),
      fixed: mark.place === "centre",
      rank: mark.role === "handle" ? 0 : 1,
      ...(toward ? { toward } : {}),
    };
  });
  placeLabels(requests, obstacles, bounds).forEach((placed, i) => {
    if (!placed) return;
    const { mark, text } = seen[i]!;
    const at = [placed.box.left, placed.box.top + text.ascent];
    // Letters on the filled region of a weight need no rim, and get one nowhere else without a reason.
    // Over surfaces, light and dark by turns, they need one.
    const rimmed = placed.crossed || transform.space !== undefined;
    const part = rimmed && mark.role !== "weight" ? "text" : "plain";
    if (isLit(mark, sheet) && !shown.has(mark.name)) {
      primitives.push({ kind: "path", ...base(mark, "shine"), steps: frameOf(placed.box) });
    }
    primitives.push({ kind: "text", ...base(mark, part), at, anchor: "start", runs: text.runs });
  });
}

/** The outline of a box with a little air. */
function frameOf({ left, top, width, height }: Box): PathStep[] {
  const [x0, y0, x1, y1] = [left - 4, top - 3, left + width + 4, top + height + 3];
  return [["M", [x0, y0]], ["L", [x1, y0]], ["L", [x1, y1]], ["L", [x0, y1]], ["Z"]];
}

/** A number on a weight's region is left out where the region is too small for it. */
function fits(
  mark: LabelMark,
  [x, y]: readonly [number, number],
  text: SetText,
  { regions }: Sheet,
): boolean {
  if (mark.role !== "weight" || mark.place !== "centre") return true;
  const region = regions.findLast(
    ({ left, top, width, height }) => x >= left && x <= left + width && y >= top && y <= top + height,
  );
  return !region || (text.width + 4 <= region.width && text.ascent + text.descent <= region.height);
}

/** The radius of what is drawn around the very point of a label: its handle, its weight. */
function taken([x, y]: readonly [number, number], { obstacles }: Sheet): number {
  let radius = 2;
  for (const circle of obstacles.circles) {
    if (Math.hypot(circle.x - x, circle.y - y) < 1) radius = Math.max(radius, circle.r);
  }
  return radius;
}
