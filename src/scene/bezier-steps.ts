import { elevateDegree, splitBezier } from "../math/index.ts";
import type { PathStep, XY } from "./marks.ts";

/**
 * The drawing of a Bézier curve, exact up to degree 3; a curve of higher degree is drawn as cubic pieces
 * that agree with it in end points and end tangents, fine enough for print.
 */
export function bezierSteps(
  controlPoints: readonly XY[],
  [from, to]: readonly [number, number] = [0, 1],
): PathStep[] {
  let part: readonly XY[] = controlPoints;
  if (to < 1) part = splitBezier(part, to)[0];
  if (from > 0) part = splitBezier(part, from / to)[1];
  if (part.length === 1) part = elevateDegree(part);
  const start: PathStep = ["M", part[0]!];
  if (part.length === 2) return [start, ["L", part[1]!]];
  if (part.length === 3) return [start, ["Q", part[1]!, part[2]!]];
  if (part.length === 4) return [start, ["C", part[1]!, part[2]!, part[3]!]];
  return [start, ...cubicPieces(part, Math.ceil(Math.log2(part.length)) + 2)];
}

/** Halves the curve `depth` times and takes from each piece its ends and end tangents. */
function cubicPieces(part: readonly XY[], depth: number): PathStep[] {
  if (depth > 0) {
    const [left, right] = splitBezier(part, 0.5);
    return [...cubicPieces(left, depth - 1), ...cubicPieces(right, depth - 1)];
  }
  const n = part.length - 1;
  const [first, second, beforeLast, last] = [part[0]!, part[1]!, part[n - 1]!, part[n]!];
  const toward = (a: XY, b: XY) => a.map((x, k) => x + ((b[k]! - x) * n) / 3);
  return [["C", toward(first, second), toward(last, beforeLast), last]];
}
