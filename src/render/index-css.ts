import type { XY } from "../scene/marks.ts";
import { INDEX_COUNT } from "./palette.ts";
import { SHAPES, shapeSteps } from "./shapes.ts";

/**
 * The index palette for pages: what bears `data-index` has its colour in `--own` and its shape in `--shape`, to be used as
 * a clip path of a square. The same shapes as in the figures.
 */
export function indexCss(): string {
  return Array.from({ length: INDEX_COUNT }, (_, i) => {
    const shape = SHAPES[i]!;
    const clip = shape === "disc" ? "circle(33%)" : `polygon(${corners(shape).map(percent).join()})`;
    return `[data-index="${i}"]{--own:var(--index-${i});--shape:${clip}}`;
  }).join("\n");
}

/** The corners for a square of size 1, in which the disc has a diameter of two thirds. */
function corners(shape: Parameters<typeof shapeSteps>[0]): XY[] {
  return shapeSteps(shape, [0.5, 0.5], 1 / 3).flatMap(([kind, at]) => (kind === "Z" || !at ? [] : [at]));
}

function percent([x, y]: XY): string {
  const share = (value: number) => `${Math.round(value * 1000) / 10}%`;
  return `${share(x!)} ${share(y!)}`;
}
