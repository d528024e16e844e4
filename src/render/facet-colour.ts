import type { FacetColour } from "../scene/marks.ts";
import { LEVELS, mapColour } from "./colour-map.ts";
import type { Palette, Token } from "./palette.ts";

/** The two tokens between which a side of a surface is shaded. */
export const TONES: Readonly<Record<"front" | "back" | "stripes", readonly [dim: Token, lit: Token]>> = {
  front: ["front-dim", "front-lit"],
  back: ["back-dim", "back-lit"],
  stripes: ["curve", "front-lit"],
};

type Rgb = readonly [number, number, number];

/** Red, green and blue, 0 … 255, of a colour as palettes write it: `#rrggbb` or `rgb(r, g, b)`. */
export function readColour(text: string): Rgb {
  const hex = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(text);
  if (hex) return hex.slice(1).map((part) => Number.parseInt(part, 16)) as unknown as Rgb;
  const parts = text.match(/[\d.]+/g)?.map(Number);
  if (parts && parts.length >= 3) return parts.slice(0, 3) as unknown as Rgb;
  throw new RangeError(`colour "${text}": expected #rrggbb or rgb(r, g, b)`);
}

/** The colour of a facet in a theme, 0 … 255. What has no value takes the dim tone. */
export function facetRgb(colour: FacetColour, palette: Palette): Rgb {
  if ("rgb" in colour) return colour.rgb;
  if ("map" in colour) {
    if (colour.share === null) return readColour(palette["front-dim"]);
    return mapColour(colour.map, Math.round(colour.share * (LEVELS - 1)));
  }
  const [dim, lit] = TONES[colour.between].map((token) => readColour(palette[token])) as [Rgb, Rgb];
  return dim.map((from, k) => Math.round(from + (lit[k]! - from) * colour.share)) as unknown as Rgb;
}
