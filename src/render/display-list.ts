import { layoutViews, type Views } from "../scene/layout.ts";
import type { Scene } from "../scene/marks.ts";
import { fitView, type View, type ViewTransform } from "../scene/view.ts";
import type { Lang } from "../words/words.ts";
import { drawLabels } from "./draw-labels.ts";
import { drawMark } from "./draw-mark.ts";
import { frame } from "./frame.ts";
import type { Drawing, Primitive } from "./primitives.ts";
import type { Sheet } from "./sheet.ts";

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
const STILL_FACETS = 1000;

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
      const transform = space.fit({ ...view, space }, boxes[id]!);
      transforms[id] = transform;
      const marks = space.project(scene[id] ?? [], transform.space, {
        facets: options.facets ?? STILL_FACETS,
      });
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
  drawLabels(sheet, lang, marks);
}
