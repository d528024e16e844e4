import type { Axes, XYZ } from "./camera.ts";

/*
 * How a surface is coloured: the formulas. The shader is written from the same constants, so that the picture of the
 * graphics card and the projected one agree.
 */

/** The studio light, in the directions of the picture (right, up, eye): from the left above, over the shoulder. */
export const LIGHT = unit([-0.42, 0.62, 0.66]);
/** Half way between light and eye: where the gloss sits. */
const HALFWAY = unit([LIGHT[0]!, LIGHT[1]!, LIGHT[2]! + 1]);

export const LIT = {
  base: 0.04,
  light: 0.68,
  eye: 0.22,
  gloss: 0.14,
  hardness: 28,
  halfway: HALFWAY,
} as const;

/** How many dark stripes are mirrored from below to above, and how sharp their edges are. */
export const STRIPES = { count: 11, edge: 3.5 } as const;

/** A unit normal in the directions of the picture: right, up, eye. */
export function inPicture(normal: XYZ, { right, up, eye }: Axes): readonly [number, number, number] {
  return [dot(normal, right), dot(normal, up), dot(normal, eye)];
}

/**
 * The brightness, 0 … 1, of a surface under the studio light. `n` is the unit normal of the side that is seen, in the
 * directions of the picture.
 */
export function litShare(n: XYZ): number {
  const gloss = Math.max(0, dot(n, LIT.halfway)) ** LIT.hardness;
  const share =
    LIT.base + LIT.light * Math.max(0, dot(n, LIGHT)) + LIT.eye * Math.max(0, n[2]!) + LIT.gloss * gloss;
  return Math.min(1, share);
}

/**
 * Mirrored stripes, 0 dark … 1 light: the eye's ray is reflected at the surface, and its height in the picture falls on
 * level stripes all around. They make kinks of the normal visible as breaks, kinks of the curvature as kinks.
 */
export function stripeShare(n: XYZ): number {
  // The ray e − 2(e·n)n turned outwards: r = 2(n·e)n − e; only its upward part counts.
  const height = Math.min(1, Math.max(-1, 2 * n[2]! * n[1]!));
  const wave = Math.sin(2 * STRIPES.count * Math.asin(height));
  return 0.5 + 0.5 * Math.min(1, Math.max(-1, STRIPES.edge * wave));
}

/** The usual colours of normals: x, y, z from −1 … 1 become red, green, blue from 0 … 255. */
export function normalColour(normal: XYZ): readonly [number, number, number] {
  const channel = (x: number) => Math.round(127.5 * (x + 1));
  return [channel(normal[0]!), channel(normal[1]!), channel(normal[2]!)];
}

/** The place of a value on a colour map, 0 … 1; null where there is no value. */
export function valueShare(value: number, [low, high]: readonly [number, number]): number | null {
  if (!Number.isFinite(value)) return null;
  return high > low ? Math.min(1, Math.max(0, (value - low) / (high - low))) : 0.5;
}

function dot(a: XYZ, b: XYZ): number {
  return a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
}

function unit(v: XYZ): XYZ {
  const length = Math.hypot(...v);
  return v.map((x) => x / length);
}
