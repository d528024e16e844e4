import type { Figure } from "../demo/figure.ts";
import type { Mark, PathMark, XY } from "../scene/marks.ts";

type Pixel = readonly [number, number];
type Project = (view: string, point: XY) => Pixel | null;

/** How near the pointer must come to a point, and to a line, in CSS pixels. */
const POINT = 14;
const LINE = 7;

/**
 * The name of the mark under a pixel: the nearest point, else the nearest line, else the region or disc on top. null where
 * nothing has a name.
 */
export function markAt(
  figure: Figure,
  x: number,
  y: number,
  project: Project,
  handles: ReadonlySet<string>,
): string | null {
  let best: { name: string; distance: number } | null = null;
  let under: string | null = null;
  for (const [view, marks] of Object.entries(figure.scene)) {
    for (const mark of marks) {
      if (mark.name === undefined || handles.has(mark.name)) continue;
      const { near, inside } = distanceTo(mark, x, y, (point) => project(view, point));
      if (near < (best?.distance ?? 1)) best = { name: mark.name, distance: near };
      if (inside) under = mark.name;
    }
  }
  return best?.name ?? under;
}

/** The distance as a share of the reach, below 1 for a hit; and whether the place is inside of something. */
function distanceTo(
  mark: Mark,
  x: number,
  y: number,
  project: (point: XY) => Pixel | null,
): { near: number; inside: boolean } {
  const far = { near: Infinity, inside: false };
  const away = (at: Pixel | null) => (at ? Math.hypot(at[0] - x, at[1] - y) : Infinity);
  switch (mark.kind) {
    case "point":
      return { near: away(project(mark.at)) / POINT, inside: false };
    case "disc": {
      // The area shows the weight; whoever is near the middle means the weight as well.
      const at = project(mark.at);
      return { near: Infinity, inside: away(at) < 40 * Math.sqrt(Math.abs(mark.weight)) };
    }
    case "arrow": {
      const [a, b] = [project(mark.from), project(mark.to)];
      return a && b ? { near: toSegment(a, b, x, y) / LINE, inside: false } : far;
    }
    case "path": {
      const line = flattened(mark, project);
      if (mark.paint === "fill") return { near: Infinity, inside: contains(line, x, y) };
      let near = Infinity;
      for (let i = 1; i < line.length; i++) near = Math.min(near, toSegment(line[i - 1]!, line[i]!, x, y));
      // A line gives way to a point.
      return { near: near < LINE ? 0.5 + near / (2 * LINE) : Infinity, inside: false };
    }
    default:
      return far;
  }
}

/** Pieces of an arc; enough to be hit. */
const PIECES = 12;

function flattened(mark: PathMark, project: (point: XY) => Pixel | null): Pixel[] {
  const line: Pixel[] = [];
  let last: Pixel | null = null;
  for (const step of mark.steps) {
    if (step[0] === "Z") {
      if (line[0]) line.push(line[0]);
      continue;
    }
    const points: Pixel[] = [];
    for (const point of step.slice(1) as XY[]) {
      const at = project(point);
      if (!at) return [];
      points.push(at);
    }
    const hull = last ? [last, ...points] : points;
    if (points.length === 1) line.push(points[0]!);
    else for (let i = 1; i <= PIECES; i++) line.push(between(hull, i / PIECES));
    last = points.at(-1)!;
  }
  return line;
}

function between(points: readonly Pixel[], t: number): Pixel {
  let level = points;
  while (level.length > 1) {
    level = level
      .slice(1)
      .map(
        ([x, y], i) =>
          [level[i]![0] + (x - level[i]![0]) * t, level[i]![1] + (y - level[i]![1]) * t] as const,
      );
  }
  return level[0]!;
}

function toSegment(a: Pixel, b: Pixel, x: number, y: number): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const length = dx * dx + dy * dy;
  const t = length === 0 ? 0 : Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / length));
  return Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y);
}

function contains(corners: readonly Pixel[], x: number, y: number): boolean {
  let inside = false;
  for (let i = 0, k = corners.length - 1; i < corners.length; k = i++) {
    const [a, b] = [corners[i]!, corners[k]!];
    if (a[1] > y !== b[1] > y && x < ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]) + a[0]) inside = !inside;
  }
  return inside;
}
