import type { Words } from "../words/words.ts";
import type { Label } from "./label.ts";
import type { XY } from "./marks.ts";
import type { SpaceTransform, SpaceWindow } from "./space.ts";

export type Interval = readonly [number, number];

/** One window of a figure onto a plane of its own, or into space. A figure may have several, linked by the state. */
export interface View {
  /** What is seen here, for those who hear it: "Control points and curve". */
  readonly label: Words;
  /** The part of the plane that must be seen; with `fit: "equal"` more may be seen. */
  readonly x: Interval;
  readonly y: Interval;
  /** `equal` (default): one unit is as long in x as in y. `stretch`: the intervals fill the window. */
  readonly fit?: "equal" | "stretch";
  /** Height of the window as a share of the figure's width, in the wide and in the narrow layout. */
  readonly height: number;
  readonly narrowHeight?: number;
  /** In the wide layout this window stands to the right of the one before it, this share of the width. */
  readonly beside?: number;
  readonly grid?: boolean;
  /** Axes with numbers, where the numbers matter. */
  readonly axes?: { readonly x?: Label; readonly y?: Label };
  /** This window looks into space (made by `spaceView`): its marks have three coordinates. */
  readonly space?: SpaceWindow;
}

/** A rectangle of the drawing, in pixels, y downwards. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Maps the plane of a view to the pixels of the drawing and back: the one place where y is turned over. */
export interface ViewTransform {
  /** Pixels per unit in x and in y (both positive). */
  readonly scale: XY;
  /** What is really seen. */
  readonly x: Interval;
  readonly y: Interval;
  readonly box: Box;
  /** Of a window into space only; `toPixel` then takes points of space. */
  readonly space?: SpaceTransform;
  toPixel(point: XY): readonly [number, number];
  toWorld(pixel: XY): readonly [number, number];
}

/** Fits a view into its box. */
export function fitView(view: View, box: Box): ViewTransform {
  const [x0, x1] = view.x;
  const [y0, y1] = view.y;
  let sx = box.width / (x1 - x0);
  let sy = box.height / (y1 - y0);
  if (view.fit !== "stretch") sx = sy = Math.min(sx, sy);
  const halfX = box.width / sx / 2;
  const halfY = box.height / sy / 2;
  const midX = (x0 + x1) / 2;
  const midY = (y0 + y1) / 2;
  const left = midX - halfX;
  const high = midY + halfY;
  return {
    scale: [sx, sy],
    x: [left, midX + halfX],
    y: [midY - halfY, high],
    box,
    toPixel: (p) => [box.left + (p[0]! - left) * sx, box.top + (high - p[1]!) * sy],
    toWorld: (q) => [left + (q[0]! - box.left) / sx, high - (q[1]! - box.top) / sy],
  };
}
