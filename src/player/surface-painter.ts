import type { Palette } from "../render/palette.ts";
import type { FacetsPrimitive } from "../render/primitives.ts";

/** Paints the surfaces of windows into space with the graphics card. One serves all figures of a page. */
export interface SurfacePainter {
  /** How to paint into a figure's own drawing surface, whose bitmap is `scale` times as large as its drawing. */
  painterFor(
    context: CanvasRenderingContext2D,
    palette: Palette,
    scale: number,
  ): (surfaces: FacetsPrimitive) => void;
  /** Gives back what is kept for a drawing surface. */
  forget(context: CanvasRenderingContext2D): void;
}

let loading = false;
let painter: SurfacePainter | null = null;
/** Redraws of the living figures with windows into space. */
const figures = new Set<() => void>();

function changed(next: SurfacePainter | null): void {
  painter = next;
  for (const redraw of figures) redraw();
}

/**
 * Joins a figure to the page's painter, which is loaded when the first one asks. `current` is null until it is there,
 * while the graphics card is lost, and for ever where there is none: then the projected picture serves.
 */
export function joinSurfacePainter(redraw: () => void): {
  readonly current: SurfacePainter | null;
  forget(context: CanvasRenderingContext2D): void;
  leave(): void;
} {
  figures.add(redraw);
  if (!loading) {
    loading = true;
    import("../render/three/three-painter.ts").then(
      ({ createThreePainter }) => createThreePainter(changed),
      () => {
        loading = false; // the next figure tries again
      },
    );
  }
  return {
    get current() {
      return painter;
    },
    forget: (context) => painter?.forget(context),
    leave: () => figures.delete(redraw),
  };
}
