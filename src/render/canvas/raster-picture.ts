import { LEVELS, mapColour, NO_VALUE } from "../colour-map.ts";
import type { RasterPrimitive } from "../primitives.ts";

interface Picture {
  readonly canvas: HTMLCanvasElement;
  readonly levels: Uint8Array;
  readonly colours: RasterPrimitive["colours"];
}

/** Pictures of a drawing surface by the key of their marks: made once, painted anew when values change. */
const pictures = new WeakMap<CanvasRenderingContext2D, Map<string, Picture>>();

/** The cells of a raster as a picture of one pixel a cell. */
export function rasterPicture(context: CanvasRenderingContext2D, raster: RasterPrimitive): HTMLCanvasElement {
  let own = pictures.get(context);
  if (!own) {
    own = new Map();
    pictures.set(context, own);
  }
  const kept = own.get(raster.key);
  if (kept && kept.colours === raster.colours && sameCells(kept, raster)) return kept.canvas;
  const canvas = kept?.canvas ?? document.createElement("canvas");
  canvas.width = raster.columns;
  canvas.height = raster.rows;
  paint(canvas, raster);
  own.set(raster.key, { canvas, levels: raster.levels, colours: raster.colours });
  return canvas;
}

function sameCells({ canvas, levels }: Picture, raster: RasterPrimitive): boolean {
  return (
    canvas.width === raster.columns &&
    canvas.height === raster.rows &&
    levels.every((level, i) => level === raster.levels[i])
  );
}

function paint(canvas: HTMLCanvasElement, { columns, rows, levels, colours }: RasterPrimitive): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  const image = context.createImageData(columns, rows);
  const table = Array.from({ length: LEVELS }, (_, level) => mapColour(colours, level));
  levels.forEach((level, i) => {
    if (level !== NO_VALUE) image.data.set([...table[level]!, 255], i * 4);
  });
  context.putImageData(image, 0, 0);
}
