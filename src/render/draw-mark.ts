import type { Mark } from "../scene/marks.ts";
import { drawArrow, drawPath } from "./draw-line.ts";
import { drawDisc, drawPoint } from "./draw-point.ts";
import { drawRaster } from "./draw-raster.ts";
import { drawFacets } from "./draw-surface.ts";
import type { Sheet } from "./sheet.ts";

/** Adds a mark to the sheet. The only place that knows the kinds of marks. */
export function drawMark(mark: Mark, sheet: Sheet): void {
  switch (mark.kind) {
    case "path":
      drawPath(mark, sheet);
      return;
    case "point":
      drawPoint(mark, sheet);
      return;
    case "disc":
      drawDisc(mark, sheet);
      return;
    case "arrow":
      drawArrow(mark, sheet);
      return;
    case "label":
      sheet.labels.push(mark);
      return;
    case "raster":
      drawRaster(mark, sheet);
      return;
    case "facets":
      drawFacets(mark, sheet);
      return;
    case "patch":
    case "ground":
      throw new RangeError(`mark "${mark.key}": a ${mark.kind} needs a view into space (spaceView)`);
    default: {
      const unknown: never = mark;
      throw new RangeError(`unknown kind of mark: ${JSON.stringify(unknown)}`);
    }
  }
}
