import type { XYZ } from "./camera.ts";
import type { Facet, FacetColour, PatchMark } from "./marks.ts";
import type { BehindBy } from "./occlusion.ts";
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

/**
 * The patches as facets, from the farthest to the nearest, at most about `budget` of them.
 *
 * What lies wholly behind other facets is left out, which makes pictures small. Where a facet dips into another surface
 * no order of whole facets is right: it is replaced by finer ones, of which only those that are seen are drawn, last.
 */
export function facetsOf(
  patches: readonly PatchMark[],
  samples: readonly Float64Array[],
  space: SpaceTransform,
  budget: number,
  behindBy: BehindBy,
): Facet[] {
  const step = stepFor(patches, budget);
  const sorted: Placed[] = [];
  const last: Placed[] = [];
  patches.forEach((patch, k) => {
    const places = samples[k]!;
    const rows = strides(patch.rows, step);
    const columns = strides(patch.columns, step);
    const cell = (top: number, bottom: number, left: number, right: number): Placed | null => {
      const { columns: width } = patch;
      const at = [top * width + left, bottom * width + left, bottom * width + right, top * width + right];
      const corners = at.map((a): Corner => [places[3 * a]!, places[3 * a + 1]!, places[3 * a + 2]!]);
      const area = signedArea(corners);
      // Seen from its edge, a facet covers nothing.
      if (!(Math.abs(area) > 1e-12)) return null;
      const colour = colourOf(patch, at, area > 0, space);
      const middle = [0, 1, 2].map((axis) => corners.reduce((sum, c) => sum + c[axis]!, 0) / 4);
      return { corners, middle: middle as unknown as Corner, colour, front: area > 0 };
    };
    for (let i = 1; i < rows.length; i++) {
      for (let j = 1; j < columns.length; j++) {
        const [top, bottom, left, right] = [rows[i - 1]!, rows[i]!, columns[j - 1]!, columns[j]!];
        const whole = cell(top, bottom, left, right);
        if (!whole) continue;
        const gaps = [...whole.corners, whole.middle].map(([x, y, depth]) => behindBy(x, y, depth));
        if (gaps.every((gap) => gap > 0)) continue;
        const deepest = Math.max(...gaps);
        // Just behind a rim, a far side counts as seen; the near side in front of it must still cover it.
        if (deepest === 0 || !whole.front || deepest > diameter(whole.corners)) {
          sorted.push(whole);
          continue;
        }
        for (let r = top; r < bottom; r++) {
          for (let c = left; c < right; c++) {
            const small = cell(r, r + 1, c, c + 1);
            if (small?.front && behindBy(...small.middle) === 0) last.push(small);
          }
        }
      }
    }
  });
  const byDepth = (a: Placed, b: Placed) => a.middle[2] - b.middle[2];
  return [...sorted.sort(byDepth), ...last.sort(byDepth)].map(({ corners, colour }) => ({ corners, colour }));
}

type Corner = readonly [across: number, up: number, depth: number];
type Placed = Facet & {
  readonly corners: readonly Corner[];
  readonly middle: Corner;
  readonly front: boolean;
};

function diameter([a, b, c, d]: readonly Corner[]): number {
  const length = (p: Corner, q: Corner) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  return Math.max(length(a!, c!), length(b!, d!));
}

/** Twice the area; positive if the corners run to the left, which is the front side. */
function signedArea([a, b, c, d]: readonly Corner[]): number {
  return (c![0] - a![0]) * (d![1] - b![1]) - (d![0] - b![0]) * (c![1] - a![1]);
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
  return { between: front !== (patch.accent ?? false) ? "front" : "back", share: litShare(seen) };
}

function meanNormal({ normals }: PatchMark, at: readonly number[]): XYZ | null {
  const sum = [0, 0, 0];
  for (const a of at) for (let k = 0; k < 3; k++) sum[k]! += normals[3 * a + k]!;
  const length = Math.hypot(...sum);
  return length > 1e-9 ? sum.map((x) => x / length) : null;
}
