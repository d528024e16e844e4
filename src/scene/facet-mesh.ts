import { cross, normalize, type Surface, sub } from "../math/index.ts";
import type { PatchMark } from "./marks.ts";

/**
 * A mesh of flat facets with its corners on a surface, as samples: every facet has corners and a normal of its own (the
 * strips between neighbours have no area), so that it is shaded flat.
 */
export function facetMesh(
  surface: Surface,
  [stepsU, stepsV]: readonly [number, number],
): Pick<PatchMark, "rows" | "columns" | "positions" | "normals"> {
  const [[u0, u1], [v0, v1]] = surface.domain;
  const corner = (i: number, j: number) =>
    surface.point(u0 + ((u1 - u0) * i) / stepsU, v0 + ((v1 - v0) * j) / stepsV);
  const [rows, columns] = [2 * stepsU, 2 * stepsV];
  const positions = new Float32Array(3 * rows * columns);
  const normals = new Float32Array(3 * rows * columns);
  for (let i = 0; i < stepsU; i++) {
    for (let j = 0; j < stepsV; j++) {
      const [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      // The diagonals span the facet also where one of its sides is a point.
      const normal = normalize(cross(sub(c, a), sub(d, b))) ?? [0, 0, 0];
      [a, b, d, c].forEach((point, k) => {
        const at = 3 * ((2 * i + (k % 2)) * columns + 2 * j + (k > 1 ? 1 : 0));
        positions.set(point, at);
        normals.set(normal, at);
      });
    }
  }
  return { rows, columns, positions, normals };
}
