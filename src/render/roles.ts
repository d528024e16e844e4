import type { Role } from "../scene/marks.ts";
import type { Token } from "./palette.ts";

/** How the marks of a role look. A mark with an index takes its index colour instead of the token. */
export interface RoleStyle {
  readonly token: Token;
  /** Colour of lettering, where it is not that of the lines. */
  readonly text?: Token;
  /** Width of lines, in pixels at scale 1. */
  readonly width: number;
  readonly dash?: readonly number[];
  /** Opacity of regions. */
  readonly fill: number;
}

/** The one table that says what a role looks like. */
export const ROLES: Readonly<Record<Role, RoleStyle>> = {
  curve: { token: "curve", width: 2.5, fill: 0.1 },
  "curve-rest": { token: "rest", text: "soft", width: 2, fill: 0.06 },
  "control-polygon": { token: "polygon", text: "soft", width: 1.25, fill: 0.06 },
  handle: { token: "lath", width: 1.75, fill: 0.14 },
  derived: { token: "lath", width: 1.25, fill: 0.1 },
  tangent: { token: "lath", width: 1.75, fill: 0.1 },
  hull: { token: "ink", text: "soft", width: 1, fill: 0.05 },
  weight: { token: "lath", text: "paper", width: 1.5, fill: 1 },
  ghost: { token: "soft", width: 1.5, dash: [5, 4], fill: 0.05 },
  guide: { token: "soft", width: 1, dash: [2, 3], fill: 0.05 },
  reference: { token: "ink", width: 1.25, dash: [7, 4], fill: 0.05 },
  good: { token: "good", width: 2, fill: 0.14 },
  bad: { token: "bad", width: 2, fill: 0.14 },
  grid: { token: "grid", text: "soft", width: 1, fill: 0.5 },
  axis: { token: "soft", width: 1, fill: 0.2 },
  surface: { token: "front-dim", text: "soft", width: 0.7, fill: 1 },
  mesh: { token: "mesh", text: "soft", width: 0.8, fill: 0.05 },
  shadow: { token: "shadow", text: "soft", width: 1, fill: 0.09 },
  note: { token: "ink", width: 1.25, fill: 0.06 },
};

/** `own`: the colour of the mark; `role`: as the table of roles says. */
export interface PartStyle {
  readonly fill?: "own" | "text" | "paper";
  readonly fillOpacity?: number | "role";
  readonly stroke?: "own" | "paper";
  readonly width?: number | "role";
  readonly opacity?: number;
  readonly dash?: "role";
}

/** What a primitive is to its mark. Every mark is drawn from these few parts. */
export const PARTS = {
  /** A line of the role. */
  line: { stroke: "own", width: "role", dash: "role" },
  /** A region of the role, seen through. */
  area: { fill: "own", fillOpacity: "role" },
  /** Something full: heads of arrows. */
  solid: { fill: "own" },
  /** A full point, cut out of the lines below it. */
  point: { fill: "own", stroke: "paper", width: 1.5 },
  /** A hollow point. */
  hollow: { fill: "paper", stroke: "own", width: 1.5 },
  /** The ring of a handle. */
  ring: { fill: "paper", stroke: "own", width: 1.75 },
  /** The disc of a weight, and the outline of a negative one. */
  disc: { fill: "own", fillOpacity: 0.17 },
  outline: { stroke: "own", width: 1.5 },
  /** The light around a mark that is pointed at: below lines, below points. */
  glow: { stroke: "own", width: 9, opacity: 0.28 },
  shine: { fill: "own", fillOpacity: 0.28 },
  /** Lettering, with a rim of paper so that lines do not run into it. */
  text: { fill: "text", stroke: "paper", width: 3.5 },
  /** Lettering on a filled region or at an axis. */
  plain: { fill: "text" },
} as const satisfies Readonly<Record<string, PartStyle>>;

export type Part = keyof typeof PARTS;
