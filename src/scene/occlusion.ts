import { stepFor, strides } from "./facets.ts";
import type { PatchMark } from "./marks.ts";

/** Whether a place of the picture, at a depth towards the eye, lies behind a surface. */
export type IsHidden = (x: number, y: number, depth: number) => boolean;

/** How far a place lies behind the foremost surface there; 0 where it is seen. */
export type BehindBy = (x: number, y: number, depth: number) => number;

/** More cells than this are thinned out: what hides need not be as fine as what is seen. */
const MOST_CELLS = 2600;
/** The picture is cut into so many fields each way, and each field knows the triangles that reach into it. */
const FIELDS = 40;
/**
 * How far behind a triangle counts as hidden, as a share of the scene's size: a curve on a surface lies up to the sag of
 * a chord behind its facets. Towards the rim, where surfaces are seen at a slant, that is more along the line of sight.
 */
const SLACK = 0.006;
const MOST_SLANT = 8;

const NOTHING: BehindBy = () => 0;

/** What hides what: exact tests against the facets, at arbitrary places, for lines, points and letters. */
export function occlusion(patches: readonly PatchMark[], samples: readonly Float64Array[]): BehindBy {
  const bounds = extent(samples);
  if (!bounds) return NOTHING;
  const { low, high, size } = bounds;
  const scaleX = FIELDS / Math.max(high[0]! - low[0]!, 1e-9);
  const scaleY = FIELDS / Math.max(high[1]! - low[1]!, 1e-9);
  const field = (value: number, from: number, scale: number) =>
    Math.min(FIELDS - 1, Math.max(0, Math.floor((value - from) * scale)));
  const fields: number[][] = Array.from({ length: FIELDS * FIELDS }, () => []);
  // Each triangle: a corner, the two edges from it, the inverse of their determinant, and its slack.
  const triangles: number[] = [];
  const slack = SLACK * size;

  const add = (places: Float64Array, a: number, b: number, c: number) => {
    const [ax, ay, az] = [places[a]!, places[a + 1]!, places[a + 2]!];
    const [bx, by, bz] = [places[b]! - ax, places[b + 1]! - ay, places[b + 2]! - az];
    const [cx, cy, cz] = [places[c]! - ax, places[c + 1]! - ay, places[c + 2]! - az];
    const det = bx * cy - by * cx;
    const normal = Math.hypot(by * cz - bz * cy, bz * cx - bx * cz, det);
    if (!(Math.abs(det) > normal * 0.01)) return; // seen from its edge
    const slant = Math.min(MOST_SLANT, normal / Math.abs(det));
    const id = triangles.push(ax, ay, az, bx, by, bz, cx, cy, cz, 1 / det, slack * slant) - 11;
    const [x0, x1] = [ax + Math.min(0, bx, cx), ax + Math.max(0, bx, cx)];
    const [y0, y1] = [ay + Math.min(0, by, cy), ay + Math.max(0, by, cy)];
    for (let i = field(x0, low[0]!, scaleX); i <= field(x1, low[0]!, scaleX); i++) {
      for (let j = field(y0, low[1]!, scaleY); j <= field(y1, low[1]!, scaleY); j++) {
        fields[i * FIELDS + j]!.push(id);
      }
    }
  };
  const step = stepFor(patches, MOST_CELLS);
  patches.forEach(({ rows, columns }, k) => {
    const places = samples[k]!;
    const [down, along] = [strides(rows, step), strides(columns, step)];
    for (let i = 1; i < down.length; i++) {
      for (let j = 1; j < along.length; j++) {
        const corner = (r: number, c: number) => 3 * (down[r]! * columns + along[c]!);
        const [a, c] = [corner(i - 1, j - 1), corner(i, j)];
        add(places, a, corner(i, j - 1), c);
        add(places, a, c, corner(i - 1, j));
      }
    }
  });

  return (x, y, depth) => {
    if (x < low[0]! || x > high[0]! || y < low[1]! || y > high[1]!) return 0;
    let most = 0;
    const near = fields[field(x, low[0]!, scaleX) * FIELDS + field(y, low[1]!, scaleY)]!;
    for (const t of near) {
      const [dx, dy] = [x - triangles[t]!, y - triangles[t + 1]!];
      const inverse = triangles[t + 9]!;
      const b = (dx * triangles[t + 7]! - dy * triangles[t + 6]!) * inverse;
      const c = (dy * triangles[t + 3]! - dx * triangles[t + 4]!) * inverse;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const at = triangles[t + 2]! + b * triangles[t + 5]! + c * triangles[t + 8]!;
      const gap = at - depth;
      if (gap > triangles[t + 10]! && gap > most) most = gap;
    }
    return most;
  };
}

function extent(samples: readonly Float64Array[]): { low: number[]; high: number[]; size: number } | null {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const places of samples) {
    for (let i = 0; i < places.length; i++) {
      const x = places[i]!;
      const k = i % 3;
      if (x < low[k]!) low[k] = x;
      if (x > high[k]!) high[k] = x;
    }
  }
  const size = Math.hypot(high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!);
  return Number.isFinite(size) && size > 0 ? { low, high, size } : null;
}
