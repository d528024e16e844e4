import type { Label } from "./label.ts";

/** A point or vector of the plane (the first two entries count). */
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
  | "note"; // lettering that belongs to no other mark

interface MarkBase {
  /** Stable from frame to frame and unique in its view; renderers reuse nodes and buffers by it. */
  readonly key: string;
  readonly role: Role;
  /** An entry of the index palette, shared with the symbols of the formulas: colour of c_i and B_i. */
  readonly index?: number;
  /** The name by which a formula may tie to this mark. */
  readonly name?: string;
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

/** The closed list: a new kind fails to compile wherever marks are drawn, until it is handled. */
export type Mark = PathMark | PointMark | DiscMark | ArrowMark | LabelMark | RasterMark;

/** The marks of each view of a figure, in painting order. */
export type Scene = Readonly<Record<string, readonly Mark[]>>;
