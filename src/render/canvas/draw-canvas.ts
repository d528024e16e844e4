import type { PathStep } from "../../scene/marks.ts";
import type { Box } from "../../scene/view.ts";
import { type Paint, paintOf } from "../paint.ts";
import type { Palette } from "../palette.ts";
import type { Drawing, FacetsPrimitive, Primitive, TextPrimitive } from "../primitives.ts";
import { FONTS } from "../sizes.ts";
import { drawFacets } from "./draw-facets.ts";
import { rasterPicture } from "./raster-picture.ts";

type Context = CanvasRenderingContext2D;

/**
 * Draws a figure on a canvas whose bitmap is `scale` times as large as the drawing, in both directions. What
 * was there before is wiped out; the canvas stays transparent where nothing is drawn.
 */
export function drawCanvas(
  context: Context,
  drawing: Drawing,
  palette: Palette,
  scale: number,
  paintSurfaces?: (surfaces: FacetsPrimitive) => void,
): void {
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, drawing.width, drawing.height);
  let clip: Box | undefined;
  for (const primitive of drawing.primitives) {
    if (primitive.clip !== clip) {
      if (clip) context.restore();
      clip = primitive.clip;
      if (clip) {
        context.save();
        context.beginPath();
        context.rect(clip.left, clip.top, clip.width, clip.height);
        context.clip();
      }
    }
    if (primitive.kind === "facets" && paintSurfaces) paintSurfaces(primitive);
    else draw(context, primitive, palette);
  }
  if (clip) context.restore();
}

function draw(context: Context, primitive: Primitive, palette: Palette): void {
  const paint = faded(paintOf(primitive.role, primitive.part, primitive.index), primitive.opacity);
  switch (primitive.kind) {
    case "path":
      context.beginPath();
      for (const step of primitive.steps) trace(context, step);
      inked(context, paint, palette);
      return;
    case "circle":
      context.beginPath();
      context.arc(primitive.at[0]!, primitive.at[1]!, primitive.radius, 0, 2 * Math.PI);
      inked(context, paint, palette);
      return;
    case "text":
      lettered(context, primitive, paint, palette);
      return;
    case "raster": {
      const { left, top, width, height } = primitive.box;
      context.imageSmoothingEnabled = false;
      context.drawImage(rasterPicture(context, primitive), left, top, width, height);
      return;
    }
    case "facets":
      drawFacets(context, primitive.facets, palette);
      return;
    default: {
      const unknown: never = primitive;
      throw new RangeError(`unknown primitive: ${JSON.stringify(unknown)}`);
    }
  }
}

function faded(paint: Paint, opacity = 1): Paint {
  if (opacity === 1) return paint;
  return {
    ...paint,
    fillOpacity: paint.fillOpacity * opacity,
    strokeOpacity: paint.strokeOpacity * opacity,
  };
}

function trace(context: Context, step: PathStep): void {
  switch (step[0]) {
    case "M":
      context.moveTo(step[1][0]!, step[1][1]!);
      return;
    case "L":
      context.lineTo(step[1][0]!, step[1][1]!);
      return;
    case "Q":
      context.quadraticCurveTo(step[1][0]!, step[1][1]!, step[2][0]!, step[2][1]!);
      return;
    case "C": {
      const [, a, b, c] = step;
      context.bezierCurveTo(a[0]!, a[1]!, b[0]!, b[1]!, c[0]!, c[1]!);
      return;
    }
    case "Z":
      context.closePath();
      return;
  }
}

function pens(context: Context, paint: Paint, palette: Palette): void {
  if (paint.fill) context.fillStyle = palette[paint.fill];
  if (!paint.stroke) return;
  context.strokeStyle = palette[paint.stroke];
  context.lineWidth = paint.width;
  context.lineJoin = "round";
  context.lineCap = paint.dash ? "butt" : "round";
  context.setLineDash(paint.dash ? [...paint.dash] : []);
}

function inked(context: Context, paint: Paint, palette: Palette): void {
  pens(context, paint, palette);
  if (paint.fill) {
    context.globalAlpha = paint.fillOpacity;
    context.fill();
  }
  if (paint.stroke) {
    context.globalAlpha = paint.strokeOpacity;
    context.stroke();
  }
  context.globalAlpha = 1;
}

function lettered(
  context: Context,
  { at, anchor, runs }: TextPrimitive,
  paint: Paint,
  palette: Palette,
): void {
  pens(context, paint, palette);
  context.textAlign = anchor === "middle" ? "center" : anchor;
  context.textBaseline = "alphabetic";
  const each = (put: (text: string, x: number, y: number) => void) => {
    for (const { text, font, size, dx, dy } of runs) {
      context.font = `${font === "math" ? "italic " : ""}${size}px ${FONTS[font]}`;
      put(text, at[0]! + dx, at[1]! + dy);
    }
  };
  context.globalAlpha = paint.fillOpacity;
  // First every rim, then every letter: no rim may cut into the letter before it.
  if (paint.stroke) each((text, x, y) => context.strokeText(text, x, y));
  each((text, x, y) => context.fillText(text, x, y));
  context.globalAlpha = 1;
}
