import type { Label } from "./label.ts";

/** A point or vector of the plane (the first two entries count), in a window into space of three coordinates. */
export type XY = readonly number[];

/**
 * What a mark means. The theme, and only the theme, says how a role looks on the screen, in the dark, with
 * forced colours and on paper.
 */
export type Role =
  | "curve" // the subject of the figure
  | "curve-rest" // the part of the curve that is not under discussion
  | "control-polygon"
  | "handle" // what the reader can move
  | "derived" // what follows from a construction: de Casteljau's legs and points
  | "tangent"
  | "hull"
  | "weight" // the area of a disc shows a weight
  | "ghost" // what was, or what could be
  | "guide" // helping lines: verticals, brackets, level lines
  | "reference" // the line to compare with: the sum 1, the exact function
  | "good"
  | "bad"
  | "grid"
  | "axis"
  | "surface"
  | "mesh" // lines of a surface itself, seen only where it is
  | "shadow" // of a surface, on the ground
  | "note"; // lettering that belongs to no other mark

interface MarkBase {
  /** Stable from frame to frame and unique in its view; renderers reuse nodes and buffers by it. */
  readonly key: string;
  readonly role: Role;
  /** An entry of the index palette, shared with the symbols of the formulas: colour of c_i and B_i. */
  readonly index?: number;
  /** The name by which a formula may tie to this mark. */
  readonly name?: string;
  /** Opacity of what lies behind a surface, 0 … 1; set by the projection of space. */
  readonly fade?: number;
}

/** Lines, and Bézier arcs that stay Bézier arcs in every output. */
export type PathStep =
  | readonly ["M", XY]
  | readonly ["L", XY]
  | readonly ["Q", XY, XY]
  | readonly ["C", XY, XY, XY]
  | readonly ["Z"];

export interface PathMark extends MarkBase {
  readonly kind: "path";
  readonly steps: readonly PathStep[];
  /** `fill` paints the inside as a region of the role, `both` its outline as well. Default: `stroke`. */
  readonly paint?: "stroke" | "fill" | "both";
}

export interface PointMark extends MarkBase {
  readonly kind: "point";
  readonly at: XY;
  /** `small` for points of a construction. */
  readonly size?: "small" | "normal";
  /** Hollow points are results of a construction; full points are given. */
  readonly hollow?: boolean;
  /** Size as a share of the usual one: what is far is a little smaller. Set by the projection of space. */
  readonly scale?: number;
}

/** A weight shown as the area of a disc: full size for 1, hollow with a minus sign where negative. */
export interface DiscMark extends MarkBase {
  readonly kind: "disc";
  readonly at: XY;
  readonly weight: number;
}

export interface ArrowMark extends MarkBase {
  readonly kind: "arrow";
  readonly from: XY;
  readonly to: XY;
}

export interface LabelMark extends MarkBase {
  readonly kind: "label";
  readonly at: XY;
  readonly label: Label;
  /**
   * Where the label should stand: `auto` (default) beside its point, where it covers neither handle nor
   * other label, preferably on the side `toward` points to; `centre` exactly on the point.
   */
  readonly place?: "auto" | "centre";
  readonly toward?: XY;
}

/** Values on a regular grid, painted as cells; `values[row * columns + column]`, row 0 at the low y. */
export interface RasterMark extends MarkBase {
  readonly kind: "raster";
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
  readonly columns: number;
  readonly rows: number;
  readonly values: ArrayLike<number>;
  readonly range: readonly [number, number];
  readonly colours: "sequential" | "diverging";
}

/** What the colour of a surface shows: light, the direction of its normals, a value, or mirrored stripes. */
export type Shading = "lit" | "normals" | "values" | "stripes";

/**
 * A surface in space as a grid of samples, row by row: sample (i, j) has its coordinates at 3·(i·columns + j). The rows
 * run with u, the columns with v; S_u × S_v points to the front side.
 */
export interface PatchMark extends MarkBase {
  readonly kind: "patch";
  readonly role: "surface";
  readonly rows: number;
  readonly columns: number;
  readonly positions: ArrayLike<number>;
  /** Unit normals; three zeros where there is none. */
  readonly normals: ArrayLike<number>;
  readonly shading?: Shading;
  /** In the warm tones of the other side: the piece that is spoken of. */
  readonly accent?: boolean;
  /** For `values`: one a sample, NaN where there is none, and the ends of the colour map. */
  readonly values?: ArrayLike<number>;
  readonly range?: readonly [number, number];
}

/** The ground under the things in space: a grid at height z, and their shadow. */
export interface GroundMark extends MarkBase {
  readonly kind: "ground";
  readonly role: "grid";
  readonly z: number;
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
  readonly step: number;
}

/** The colour of a facet: a share between two colours of the theme, a place on a colour map, or a colour as it is. */
export type FacetColour =
  | { readonly between: "front" | "back" | "stripes"; readonly share: number }
  | { readonly map: "diverging"; readonly share: number | null }
  | { readonly rgb: readonly [number, number, number] };

/** A small piece of a surface in the plane of the picture. */
export interface Facet {
  readonly corners: readonly XY[];
  readonly colour: FacetColour;
}

/** Surfaces of space, projected: facets from the farthest to the nearest. */
export interface FacetsMark extends MarkBase {
  readonly kind: "facets";
  readonly role: "surface";
  readonly facets: readonly Facet[];
  /** The surfaces themselves, for a renderer that can draw them. */
  readonly patches: readonly PatchMark[];
}

/** The closed list: a new kind fails to compile wherever marks are drawn, until it is handled. */
export type Mark =
  | PathMark
  | PointMark
  | DiscMark
  | ArrowMark
  | LabelMark
  | RasterMark
  | PatchMark
  | GroundMark
  | FacetsMark;

/** The marks of each view of a figure, in painting order. */
export type Scene = Readonly<Record<string, readonly Mark[]>>;
