import type { PathStep, XY } from "../scene/marks.ts";
import { SIZE } from "./sizes.ts";

/** An arrow in pixels: its shaft, which ends inside the head, and the head's outline. */
export interface Arrow {
  readonly shaft: readonly PathStep[];
  readonly head: readonly PathStep[];
}

/** The arrow between two points; null where it is shorter than half a pixel and has no direction to show. */
export function arrow([x0, y0]: XY, [x1, y1]: XY): Arrow | null {
  const [dx, dy] = [x1! - x0!, y1! - y0!];
  const length = Math.hypot(dx, dy);
  if (length < 0.5) return null;
  const [ux, uy] = [dx / length, dy / length];
  // A short arrow keeps its shape: the head shrinks with it.
  const size = Math.min(1, length / (SIZE.arrowLength * 1.2));
  const [long, half] = [SIZE.arrowLength * size, (SIZE.arrowWidth / 2) * size];
  const at = (back: number, side: number): XY => [x1! - ux * back - uy * side, y1! - uy * back + ux * side];
  return {
    shaft: [
      ["M", [x0!, y0!]],
      ["L", at(long * 0.75, 0)],
    ],
    head: [
      ["M", [x1!, y1!]],
      ["L", at(long, half)],
      ["L", at(long * 0.72, 0)],
      ["L", at(long, -half)],
      ["Z"],
    ],
  };
}
