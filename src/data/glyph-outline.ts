import type { Point } from "../math/index.ts";

/**
 * The outline of a letter as a TrueType font stores it: points of closed contours, on the curve or beside it.
 *
 * Between two neighbouring points beside the curve the font leaves out the point on the curve: it is their midpoint.
 */
export interface GlyphOutline {
  readonly letter: string;
  readonly unitsPerEm: number;
  readonly points: readonly Point[];
  /** For each point whether it lies on the curve. */
  readonly onCurve: readonly boolean[];
  /** For each contour the index of its last point. */
  readonly ends: readonly number[];
}

/** A piece of an outline: a segment (2 control points) or a quadratic Bézier curve (3). */
export interface Arc {
  readonly controlPoints: readonly Point[];
  /** The stored points that shape it: its own, and those whose midpoint it begins or ends at. */
  readonly from: readonly number[];
}

interface Stop {
  readonly at: Point;
  readonly on: boolean;
  readonly from: readonly number[];
}

/** The arcs of each contour, in drawing order; every contour has at least two points. */
export function outlineArcs({
  points,
  onCurve,
  ends,
}: Pick<GlyphOutline, "points" | "onCurve" | "ends">): Arc[][] {
  return ends.map((end, c) => {
    const first = c === 0 ? 0 : ends[c - 1]! + 1;
    const stops = withMidpoints(
      points.slice(first, end + 1).map((at, k) => ({ at, on: onCurve[first + k]!, from: [first + k] })),
    );
    return arcsThrough(stops);
  });
}

/** The closed contour with the points that the font leaves out, beginning at a point on the curve. */
function withMidpoints(stored: readonly Stop[]): Stop[] {
  const all = stored.flatMap((stop, k): Stop[] => {
    const next = stored[(k + 1) % stored.length]!;
    if (stop.on || next.on) return [stop];
    const middle = stop.at.map((x, axis) => (x + next.at[axis]!) / 2);
    return [stop, { at: middle, on: true, from: [...stop.from, ...next.from] }];
  });
  const start = all.findIndex((stop) => stop.on);
  return [...all.slice(start), ...all.slice(0, start)];
}

function arcsThrough(stops: readonly Stop[]): Arc[] {
  const arcs: Arc[] = [];
  let piece: Stop[] = [];
  for (const stop of [...stops, stops[0]!]) {
    piece.push(stop);
    if (piece.length < 2 || !stop.on) continue;
    const from = [...new Set(piece.flatMap((each) => each.from))];
    arcs.push({ controlPoints: piece.map((each) => each.at), from });
    piece = [stop];
  }
  return arcs;
}
