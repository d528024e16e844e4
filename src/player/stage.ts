import type { Figure } from "../demo/figure.ts";
import { drawCanvas } from "../render/canvas/draw-canvas.ts";
import { displayList } from "../render/display-list.ts";
import type { XY } from "../scene/marks.ts";
import type { SpaceTransform } from "../scene/space.ts";
import type { ViewTransform } from "../scene/view.ts";
import { element } from "./element.ts";
import type { FrameOptions } from "./frame.ts";
import { currentPalette } from "./palette.ts";
import type { SurfacePainter } from "./surface-painter.ts";

/** The drawing surface of a figure: a canvas that fills its box, sharp on every pixel ratio. */
export interface Stage {
  readonly root: HTMLElement;
  readonly context: CanvasRenderingContext2D | null;
  measure(): void;
  /** Draws the figure and gives back where its views are, in drawing units, and CSS pixels per unit. */
  draw(
    figure: Figure,
    lit: ReadonlySet<string>,
    painter: SurfacePainter | null,
  ): { views: Readonly<Record<string, ViewTransform>>; scale: number };
  /** The place under a pixel; in space, in the plane through a point parallel to the picture. */
  toWorld(view: string, x: number, y: number, through: XY): XY | null;
  /** How a view looks into space, if it does. */
  spaceOf(view: string): SpaceTransform | null;
  /** The window into space under a pixel, and its size in CSS pixels. */
  windowAt(x: number, y: number): { readonly space: SpaceTransform; readonly size: number } | null;
  toStage(view: string, point: XY): readonly [number, number] | null;
  destroy(): void;
}

/** The size, in drawing units, that a figure in a slide or on a full screen is drawn for. */
const SLIDE_WIDTH = 720;

/** About how many facets a surface has that is drawn without a graphics card and follows the hand. */
const LIVE_FACETS = 2600;

export function createStage(options: FrameOptions, resized: () => void): Stage {
  const canvas = element("canvas", { "aria-hidden": "true" });
  const root = element("div", { class: "stage" }, canvas);
  const context = canvas.getContext("2d");
  let width = 0;
  let height = 0;
  let scale = 1;
  let views: Readonly<Record<string, ViewTransform>> = {};

  const measure = () => {
    width = root.clientWidth;
    height = root.clientHeight;
    // A slide is read from the last row: type and strokes grow with the frame. Pages keep their size.
    scale =
      width > SLIDE_WIDTH * 1.1
        ? Math.min(width / SLIDE_WIDTH, Math.max(1, height / (SLIDE_WIDTH * 0.5)))
        : 1;
  };
  /** The backing store follows the pixel ratio, which changes with zoom and from screen to screen. */
  const fitCanvas = () => {
    const ratio = options.dpr ?? window.devicePixelRatio;
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== w) canvas.width = w;
    if (canvas.height !== h) canvas.height = h;
  };
  const observer = new ResizeObserver(() => {
    if (root.clientWidth === width && root.clientHeight === height) return;
    measure();
    resized();
  });
  observer.observe(root);

  return {
    root,
    context,
    measure,
    draw(figure, lit, painter) {
      // A frame of size 0 (a slide not yet shown) is drawn once it has a size.
      if (width === 0 || height === 0) return { views, scale };
      fitCanvas();
      const drawing = displayList(figure.views, figure.scene, {
        width: width / scale,
        height: height / scale,
        lang: options.lang,
        lit,
        facets: painter ? 0 : LIVE_FACETS,
      });
      views = drawing.views;
      if (context) {
        const palette = currentPalette(options.theme);
        const ratio = (canvas.width / width) * scale;
        const paint = painter?.painterFor(context, palette, ratio);
        drawCanvas(context, drawing, palette, ratio, paint);
      }
      return { views, scale };
    },
    toWorld: (view, x, y, through) => {
      const found = views[view];
      const pixel = [x / scale, y / scale] as const;
      return found?.space ? found.space.lift(pixel, through) : (found?.toWorld(pixel) ?? null);
    },
    spaceOf: (view) => views[view]?.space ?? null,
    windowAt(x, y) {
      for (const { space, box } of Object.values(views)) {
        if (!space) continue;
        const [right, down] = [x / scale - box.left, y / scale - box.top];
        if (right < 0 || down < 0 || right > box.width || down > box.height) continue;
        return { space, size: Math.min(box.width, box.height) * scale };
      }
      return null;
    },
    toStage: (view, point) => {
      const pixel = views[view]?.toPixel(point);
      return pixel ? [pixel[0] * scale, pixel[1] * scale] : null;
    },
    destroy: () => observer.disconnect(),
  };
}
