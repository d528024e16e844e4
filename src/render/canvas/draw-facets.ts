import type { Facet } from "../../scene/marks.ts";
import { facetRgb } from "../facet-colour.ts";
import type { Palette } from "../palette.ts";

/** A rim in the facet's own colour closes the hair lines between neighbours. */
const RIM = 0.8;

/** Paints facets in their order, each over those before. */
export function drawFacets(
  context: CanvasRenderingContext2D,
  facets: readonly Facet[],
  palette: Palette,
): void {
  context.lineWidth = RIM;
  context.lineJoin = "round";
  context.setLineDash([]);
  for (const { corners, colour } of facets) {
    context.fillStyle = context.strokeStyle = `rgb(${facetRgb(colour, palette).join()})`;
    context.beginPath();
    corners.forEach(([x, y], k) => {
      if (k === 0) context.moveTo(x!, y!);
      else context.lineTo(x!, y!);
    });
    context.closePath();
    context.fill();
    context.stroke();
  }
}
