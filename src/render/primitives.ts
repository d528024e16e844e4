import type { Facet, PatchMark, PathStep, Role, XY } from "../scene/marks.ts";
import type { SpaceTransform } from "../scene/space.ts";
import type { Box, ViewTransform } from "../scene/view.ts";
import type { Part } from "./roles.ts";
import type { Font } from "./sizes.ts";

interface PrimitiveBase {
  readonly role: Role;
  readonly part: Part;
  readonly index?: number;
  /** The window that cuts this primitive; absent where nothing of it lies outside. */
  readonly clip?: Box;
  /** Less than 1 for what lies behind a surface. */
  readonly opacity?: number;
}

/** A path in pixels; Bézier arcs are the mark's own, mapped. */
export interface PathPrimitive extends PrimitiveBase {
  readonly kind: "path";
  readonly steps: readonly PathStep[];
}

export interface CirclePrimitive extends PrimitiveBase {
  readonly kind: "circle";
  readonly at: XY;
  readonly radius: number;
}

/** A piece of lettering in one font and size, set from its own place on. */
export interface TextRun {
  readonly text: string;
  readonly font: Font;
  readonly size: number;
  /** Start of the run's baseline, from the place of the text. */
  readonly dx: number;
  readonly dy: number;
}

/** Lettering: runs, each from its own place on, or ending or centred there. */
export interface TextPrimitive extends PrimitiveBase {
  readonly kind: "text";
  readonly at: XY;
  readonly anchor: "start" | "middle" | "end";
  readonly runs: readonly TextRun[];
}

/** Cells in a rectangle, row 0 at the top; each is a level of the colour map, `NO_VALUE` is not painted. */
export interface RasterPrimitive extends PrimitiveBase {
  readonly kind: "raster";
  readonly key: string;
  readonly box: Box;
  readonly columns: number;
  readonly rows: number;
  readonly levels: Uint8Array;
  readonly colours: "sequential" | "diverging";
}

/** The surfaces of a window into space: facets in pixels, from far to near, and what they were made from. */
export interface FacetsPrimitive extends PrimitiveBase {
  readonly kind: "facets";
  readonly facets: readonly Facet[];
  readonly patches: readonly PatchMark[];
  readonly space: SpaceTransform;
}

/** All that a renderer must know how to draw. */
export type Primitive = PathPrimitive | CirclePrimitive | TextPrimitive | RasterPrimitive | FacetsPrimitive;

/** A figure in pixels at scale 1, in painting order, and how its windows map to their planes. */
export interface Drawing {
  readonly width: number;
  readonly height: number;
  readonly primitives: readonly Primitive[];
  readonly views: Readonly<Record<string, ViewTransform>>;
}
