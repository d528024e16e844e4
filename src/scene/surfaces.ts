import type { Surface } from "../math/index.ts";
import { limitNormal, surfaceNormal } from "../math/index.ts";
import { arrow, label } from "./draw.ts";
import { symbol } from "./label.ts";
import type { GroundMark, Mark, PatchMark } from "./marks.ts";

type PatchExtra = Partial<Pick<PatchMark, "name" | "index" | "shading" | "values" | "range" | "accent">>;

/** A surface as a mark, from its samples. */
export function patch(
  key: string,
  samples: Pick<PatchMark, "rows" | "columns" | "positions" | "normals">,
  extra: PatchExtra = {},
): PatchMark {
  return { kind: "patch", role: "surface", key, ...samples, ...extra };
}

/** Samples of any surface in space over a part of its domain, with normals, or their limits, or zeros. */
export function sampleSurface(
  surface: Surface,
  steps: readonly [number, number],
  [[u0, u1], [v0, v1]]: Surface["domain"] = surface.domain,
): Pick<PatchMark, "rows" | "columns" | "positions" | "normals"> {
  const [rows, columns] = [steps[0] + 1, steps[1] + 1];
  const positions = new Float32Array(3 * rows * columns);
  const normals = new Float32Array(3 * rows * columns);
  for (let i = 0, at = 0; i < rows; i++) {
    // The ends exactly, for the limits of normals are looked for there.
    const u = i === rows - 1 ? u1 : u0 + ((u1 - u0) * i) / steps[0];
    for (let j = 0; j < columns; j++, at += 3) {
      const v = j === columns - 1 ? v1 : v0 + ((v1 - v0) * j) / steps[1];
      positions.set(surface.point(u, v), at);
      const normal = surfaceNormal(surface, u, v) ?? limitNormal(surface, u, v);
      if (normal) normals.set(normal, at);
    }
  }
  return { rows, columns, positions, normals };
}

/** The ground below the things in space. */
export function ground(
  z: number,
  x: readonly [number, number],
  y: readonly [number, number],
  step = 1,
): GroundMark {
  return { kind: "ground", key: "ground", role: "grid", z, x, y, step };
}

/** Short arrows along the axes with their letters, to tell x from y from z. */
export function axisArrows(at: readonly number[], length: number): Mark[] {
  return ["x", "y", "z"].flatMap((letter, k): Mark[] => {
    const tip = at.map((value, axis) => value + (axis === k ? length : 0));
    const toward = at.map((_, axis) => (axis === k ? 1 : 0));
    return [
      arrow(`axis-${letter}`, "axis", at, tip),
      label(`axis-${letter}-label`, "axis", tip, symbol(letter), { toward }),
    ];
  });
}
