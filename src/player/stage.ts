import type { Demo } from "../demo/define.ts";
import type { Figure } from "../demo/figure.ts";
import { drawCanvas } from "../render/canvas/draw-canvas.ts";
import { displayList } from "../render/display-list.ts";
import type { XY } from "../scene/marks.ts";
import type { ViewTransform } from "../scene/view.ts";
import { element } from "./element.ts";
import type { FrameOptions } from "./frame.ts";
import { currentPalette } from "./palette.ts";

/** The drawing surface of a figure: a canvas that fills its box, sharp on every pixel ratio. */
export interface Stage {
  readonly root: HTMLElement;
  measure(): void;
  /** Draws the figure and gives back where its views are, in drawing units, and CSS pixels per unit. */
  draw(
    demo: Demo,
    figure: Figure,
    lit: ReadonlySet<string>,
  ): { views: Readonly<Record<string, ViewTransform>>; scale: number };
  toWorld(view: string, x: number, y: number): readonly [number, number] | null;
  toStage(view: string, point: XY): readonly [number, number] | null;
  destroy(): void;
}

/** The size, in drawing units, that a figure in a slide or on a full screen is drawn for. */
const SLIDE_WIDTH = 720;

export function createStage(options: FrameOptions, resized: () => void): Stage {
  const canvas = element("canvas", { "aria-hidden": "true" });
  const root = element("div", { class: "stage" }, canvas);
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
    measure,
    draw(demo, figure, lit) {
      // A frame of size 0 (a slide not yet shown) is drawn once it has a size.
      if (width === 0 || height === 0) return { views, scale };
      fitCanvas();
      const drawing = displayList(demo.views, figure.scene, {
        width: width / scale,
        height: height / scale,
        lang: options.lang,
        lit,
      });
      views = drawing.views;
      const context = canvas.getContext("2d");
      if (context)
        drawCanvas(context, drawing, currentPalette(options.theme), (canvas.width / width) * scale);
      return { views, scale };
    },
    toWorld: (view, x, y) => views[view]?.toWorld([x / scale, y / scale]) ?? null,
    toStage: (view, point) => {
      const pixel = views[view]?.toPixel(point);
      return pixel ? [pixel[0] * scale, pixel[1] * scale] : null;
    },
    destroy: () => observer.disconnect(),
  };
}
