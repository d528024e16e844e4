import { splitBezier } from "../math/index.ts";
import type { PathStep, XY } from "./marks.ts";
import type { IsHidden } from "./occlusion.ts";
import type { SpaceTransform } from "./space.ts";

/** A path of space in the plane of the picture: what is seen of it, and what lies behind a surface. */
export interface SplitPath {
  readonly seen: readonly PathStep[];
  readonly hidden: readonly PathStep[];
}

/** Distance of the places at which a line is tested, as a share of what the window shows across. */
const SPACING = 1 / 90;
const MOST_TESTS = 64;
const HALVINGS = 9;

/**
 * Projects a path and cuts it where it goes behind a surface. Bézier arcs stay the exact arcs they are, cut by de
 * Casteljau's construction.
 */
export function splitHidden(
  steps: readonly PathStep[],
  { project, plane }: SpaceTransform,
  isHidden: IsHidden,
): SplitPath {
  const spacing = (plane.x[1] - plane.x[0]) * SPACING;
  const seen: PathStep[] = [];
  const hidden: PathStep[] = [];
  let start: XY = [];
  let here: XY = [];
  for (const step of steps) {
    if (step[0] === "M") {
      start = here = project(step[1]);
      continue;
    }
    const arc = step[0] === "Z" ? [here, start] : [here, ...(step.slice(1) as XY[]).map(project)];
    here = arc.at(-1)!;
    const behind = (t: number) => {
      const at = pointOf(arc, t);
      return isHidden(at[0]!, at[1]!, at[2]!);
    };
    for (const [from, to, covered] of intervals(behind, testsFor(arc, spacing))) {
      append(covered ? hidden : seen, part(arc, from, to));
    }
  }
  return { seen, hidden };
}

function testsFor(arc: readonly XY[], spacing: number): number {
  let length = 0;
  for (let k = 1; k < arc.length; k++) {
    length += Math.hypot(arc[k]![0]! - arc[k - 1]![0]!, arc[k]![1]! - arc[k - 1]![1]!);
  }
  return Math.min(MOST_TESTS, Math.max(2, Math.ceil(length / spacing)));
}

/** The intervals of [0, 1] on which an arc is behind something or not; their ends found by halving. */
function intervals(behind: (t: number) => boolean, tests: number): (readonly [number, number, boolean])[] {
  const found: (readonly [number, number, boolean])[] = [];
  // The very ends often lie on a surface's rim: ask a little inside.
  const at = (k: number) => Math.min(1 - 1e-3, Math.max(1e-3, k / tests));
  let from = 0;
  let state = behind(at(0));
  for (let k = 1; k <= tests; k++) {
    if (behind(at(k)) === state) continue;
    let [low, high] = [at(k - 1), at(k)];
    for (let r = 0; r < HALVINGS; r++) {
      const middle = (low + high) / 2;
      if (behind(middle) === state) low = middle;
      else high = middle;
    }
    found.push([from, high, state]);
    from = high;
    state = !state;
  }
  found.push([from, 1, state]);
  return found;
}

function pointOf(arc: readonly XY[], t: number): XY {
  let level = arc;
  while (level.length > 1) {
    const last = level;
    level = last.slice(1).map((b, k) => b.map((x, axis) => last[k]![axis]! * (1 - t) + x * t));
  }
  return level[0]!;
}

function part(arc: readonly XY[], from: number, to: number): readonly XY[] {
  let piece: readonly XY[] = arc;
  if (to < 1) piece = splitBezier(piece, to)[0];
  if (from > 0) piece = splitBezier(piece, from / to)[1];
  return piece;
}

/** Adds an arc to a path; a new beginning only where it does not go on from the last one. */
function append(steps: PathStep[], arc: readonly XY[]): void {
  const [first, ...rest] = arc.map((p): XY => [p[0]!, p[1]!]);
  const before = steps.at(-1)?.at(-1) as XY | undefined;
  if (!before || before[0] !== first![0] || before[1] !== first![1]) steps.push(["M", first!]);
  if (rest.length === 1) steps.push(["L", rest[0]!]);
  else if (rest.length === 2) steps.push(["Q", rest[0]!, rest[1]!]);
  else steps.push(["C", rest[0]!, rest[1]!, rest[2]!]);
}
