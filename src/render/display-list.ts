import { layoutViews, type Views } from "../scene/layout.ts";
import type { LabelMark, Scene } from "../scene/marks.ts";
import { project } from "../scene/project.ts";
import { fitSpace } from "../scene/space.ts";
import { type Box, fitView, type View, type ViewTransform } from "../scene/view.ts";
import type { Lang } from "../words/words.ts";
import { frame } from "./frame.ts";
import { base, drawMark, inWindow, type Sheet } from "./mark-primitives.ts";
import { type LabelRequest, placeLabels } from "./place-labels.ts";
import type { Drawing, Primitive } from "./primitives.ts";
import { type SetText, setLabel } from "./set-label.ts";

export interface DrawingOptions {
  /** Size of the drawing in pixels at scale 1. */
  readonly width: number;
  readonly height: number;
  readonly lang: Lang;
  /** Names of the marks that are pointed at (`Mark.name`). */
  readonly lit?: ReadonlySet<string>;
  /** About how many facets the surfaces of a window may have; 0 where a renderer draws the surfaces itself. */
  readonly facets?: number;
}

/** Enough facets for a still picture. */
const STILL_FACETS = 1300;

const NONE: ReadonlySet<string> = new Set();

/**
 * What is drawn for a scene: windows side by side or below each other, grids and axes, marks, and lettering
 * that covers neither handles nor other lettering. Pure; marks of a view that is not declared are left out.
 */
export function displayList(views: Views, scene: Scene, options: DrawingOptions): Drawing {
  const boxes = layoutViews(views, options.width, options.height);
  const transforms: Record<string, ViewTransform> = {};
  const primitives: Primitive[] = [];
  for (const [id, view] of Object.entries(views)) {
    const { space } = view;
    if (space) {
      const transform = fitSpace({ ...view, space }, boxes[id]!);
      transforms[id] = transform;
      const marks = project(scene[id] ?? [], transform.space, { facets: options.facets ?? STILL_FACETS });
      // What is projected already lies in the plane of the picture.
      drawWindow(view, { ...transform.space.plane, space: transform.space }, marks, options, primitives);
      continue;
    }
    const transform = fitView(view, boxes[id]!);
    transforms[id] = transform;
    drawWindow(view, transform, scene[id] ?? [], options, primitives);
  }
  return { width: options.width, height: options.height, primitives, views: transforms };
}

function drawWindow(
  view: View,
  transform: ViewTransform,
  marks: Scene[string],
  { lang, lit = NONE }: DrawingOptions,
  primitives: Primitive[],
): void {
  primitives.push(...frame(view, transform, lang));
  const sheet: Sheet = {
    transform,
    lit,
    primitives,
    obstacles: { circles: [], lines: [] },
    regions: [],
    labels: [],
  };
  for (const mark of marks) drawMark(mark, sheet);
  drawLabels(sheet, lang);
}

/** Lettering may stand a little outside the window, but not on the numbers of an axis. */
const MARGIN = 4;

function drawLabels(sheet: Sheet, lang: Lang): void {
  const { transform, obstacles, primitives } = sheet;
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
    const part = placed.crossed && mark.role !== "weight" ? "text" : "plain";
    primitives.push({ kind: "text", ...base(mark, part), at, anchor: "start", runs: text.runs });
  });
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
