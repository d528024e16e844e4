import type { XYZ } from "./camera.ts";
import { stepFor, strides } from "./facets.ts";
import type { GroundMark, Mark, PatchMark, PathStep, XY } from "./marks.ts";
import type { SpaceTransform } from "./space.ts";

/** The ground as lines of the picture, with the shadow that the surfaces throw straight down, seen from above. */
export function projectGround(
  ground: GroundMark,
  patches: readonly PatchMark[],
  { project, axes }: SpaceTransform,
  shadowCells: number,
): Mark[] {
  const { key, z } = ground;
  const flat = (x: number, y: number): XY => project([x, y, z]).slice(0, 2);
  const lines: PathStep[] = [];
  for (const x of places(ground.x, ground.step)) {
    lines.push(["M", flat(x, ground.y[0])], ["L", flat(x, ground.y[1])]);
  }
  for (const y of places(ground.y, ground.step)) {
    lines.push(["M", flat(ground.x[0], y)], ["L", flat(ground.x[1], y)]);
  }
  const grid: Mark = { kind: "path", key, role: "grid", steps: lines };
  if (axes.eye[2]! <= 1e-9 || patches.length === 0) return [grid];
  const steps = patches.flatMap((patch) => shadowSteps(patch, stepFor(patches, shadowCells), flat));
  return [grid, { kind: "path", key: `${key}-shadow`, role: "shadow", steps, paint: "fill" }];
}

function places([from, to]: readonly [number, number], step: number): number[] {
  const count = Math.round((to - from) / step);
  return Array.from({ length: count + 1 }, (_, k) => from + ((to - from) * k) / count);
}

/** Cells laid flat, all turned the same way round, so that overlapping ones do not cancel each other. */
function shadowSteps(
  { positions, rows, columns }: PatchMark,
  step: number,
  flat: (x: number, y: number) => XY,
): PathStep[] {
  const steps: PathStep[] = [];
  const [down, along] = [strides(rows, step), strides(columns, step)];
  for (let i = 1; i < down.length; i++) {
    for (let j = 1; j < along.length; j++) {
      const corner = (r: number, c: number): XYZ => {
        const at = 3 * (down[r]! * columns + along[c]!);
        return [positions[at]!, positions[at + 1]!];
      };
      const cell = [corner(i - 1, j - 1), corner(i, j - 1), corner(i, j), corner(i - 1, j)] as const;
      const [a, b, c, d] = cell;
      const area = (c[0]! - a[0]!) * (d[1]! - b[1]!) - (d[0]! - b[0]!) * (c[1]! - a[1]!);
      if (!(Math.abs(area) > 1e-9)) continue;
      const [p, q, r, s] = (area > 0 ? cell : [d, c, b, a]).map((at) => flat(at[0]!, at[1]!));
      steps.push(["M", p!], ["L", q!], ["L", r!], ["L", s!], ["Z"]);
    }
  }
  return steps;
}
