import { mapColour, NO_VALUE } from "./colour-map.ts";
import { pngUrl } from "./png.ts";
import type { RasterPrimitive } from "./primitives.ts";
import { short } from "./short.ts";
import { node, type SvgNode } from "./svg-node.ts";

/** Few cells as rectangles, which stay sharp everywhere; many as a picture. */
const FEW = 100;

/** A raster as a group of rectangles or as a picture. */
export function rasterNode({ box, columns, rows, levels, colours }: RasterPrimitive): SvgNode {
  const { left, top, width, height } = box;
  if (columns * rows > FEW) {
    return node("image", {
      x: short(left),
      y: short(top),
      width: short(width),
      height: short(height),
      preserveAspectRatio: "none",
      style: "image-rendering:pixelated",
      href: pngUrl(columns, rows, levels, colours),
    });
  }
  const cells: SvgNode[] = [];
  levels.forEach((level, i) => {
    if (level === NO_VALUE) return;
    cells.push(
      node("rect", {
        x: short(left + ((i % columns) * width) / columns),
        y: short(top + (Math.floor(i / columns) * height) / rows),
        width: short(width / columns),
        height: short(height / rows),
        fill: `rgb(${mapColour(colours, level).join(",")})`,
      }),
    );
  });
  return node("g", { "shape-rendering": "crispEdges" }, cells);
}
