import type { XYZ } from "./camera.ts";
import type { Facet, FacetColour, PatchMark } from "./marks.ts";
import { inPicture, litShare, normalColour, stripeShare, valueShare } from "./shade.ts";
import type { SpaceTransform } from "./space.ts";

/** The projected samples of a patch: across, up, towards the eye, three numbers a sample. */
export function projectSamples(patch: PatchMark, { project }: SpaceTransform): Float64Array {
  const count = 3 * patch.rows * patch.columns;
  const out = new Float64Array(count);
  const { positions } = patch;
  for (let k = 0; k < count; k += 3) {
    out.set(project([positions[k]!, positions[k + 1]!, positions[k + 2]!]), k);
  }
  return out;
}

/** Indices 0, step, 2·step, … up to the last one, whatever the step. */
export function strides(count: number, step: number): number[] {
  const at: number[] = [];
  for (let i = 0; i < count - 1; i += step) at.push(i);
  at.push(count - 1);
  return at;
}

/** The step at which all patches together have at most about `budget` cells. */
export function stepFor(patches: readonly PatchMark[], budget: number): number {
  const cells = patches.reduce((sum, { rows, columns }) => sum + (rows - 1) * (columns - 1), 0);
  return Math.max(1, Math.ceil(Math.sqrt(cells / budget) - 1e-9));
}

/** The patches as facets, from the farthest to the nearest, at most about `budget` of them. */
export function facetsOf(
  patches: readonly PatchMark[],
  samples: readonly Float64Array[],
  space: SpaceTransform,
  budget: number,
): Facet[] {
  const step = stepFor(patches, budget);
  const found: { facet: Facet; depth: number }[] = [];
  patches.forEach((patch, k) => {
    const places = samples[k]!;
    const rows = strides(patch.rows, step);
    const columns = strides(patch.columns, step);
    for (let i = 1; i < rows.length; i++) {
      for (let j = 1; j < columns.length; j++) {
        const at = [
          rows[i - 1]! * patch.columns + columns[j - 1]!,
          rows[i]! * patch.columns + columns[j - 1]!,
          rows[i]! * patch.columns + columns[j]!,
          rows[i - 1]! * patch.columns + columns[j]!,
        ];
        const corners = at.map((a) => [places[3 * a]!, places[3 * a + 1]!] as const);
        const area = signedArea(corners);
        // Seen from its edge, a facet covers nothing.
        if (!(Math.abs(area) > 1e-12)) continue;
        const depth = at.reduce((sum, a) => sum + places[3 * a + 2]!, 0);
        found.push({ facet: { corners, colour: colourOf(patch, at, area > 0, space) }, depth });
      }
    }
  });
  found.sort((a, b) => a.depth - b.depth);
  return found.map(({ facet }) => facet);
}

/** Twice the area; positive if the corners run to the left, which is the front side. */
function signedArea(corners: readonly (readonly [number, number])[]): number {
  const [a, b, c, d] = corners as unknown as [XYZ, XYZ, XYZ, XYZ];
  return (c[0]! - a[0]!) * (d[1]! - b[1]!) - (d[0]! - b[0]!) * (c[1]! - a[1]!);
}

function colourOf(
  patch: PatchMark,
  at: readonly number[],
  front: boolean,
  { axes }: SpaceTransform,
): FacetColour {
  if (patch.shading === "values") {
    const { values = [], range = [0, 1] } = patch;
    const known = at.map((a) => values[a] ?? Number.NaN).filter(Number.isFinite);
    const mean = known.reduce((sum, x) => sum + x, 0) / known.length;
    return { map: "diverging", share: valueShare(mean, range) };
  }
  const normal = meanNormal(patch, at);
  if (patch.shading === "normals") {
    return normal ? { rgb: normalColour(normal) } : { map: "diverging", share: null };
  }
  // Where no corner has a normal the facet is shown as if it faced the eye.
  const seen = normal ? inPicture(normal, axes).map((x) => (front ? x : -x)) : [0, 0, 1];
  if (patch.shading === "stripes") return { between: "stripes", share: stripeShare(seen) };
  return { between: front ? "front" : "back", share: litShare(seen) };
}

function meanNormal({ normals }: PatchMark, at: readonly number[]): XYZ | null {
  const sum = [0, 0, 0];
  for (const a of at) for (let k = 0; k < 3; k++) sum[k]! += normals[3 * a + k]!;
  const length = Math.hypot(...sum);
  return length > 1e-9 ? sum.map((x) => x / length) : null;
}
