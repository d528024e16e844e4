import { facetsOf, projectSamples } from "./facets.ts";
import { projectGround } from "./ground.ts";
import type { ArrowMark, FacetsMark, GroundMark, Mark, PatchMark, PathMark, PathStep, XY } from "./marks.ts";
import { type IsHidden, occlusion } from "./occlusion.ts";
import type { SpaceTransform } from "./space.ts";
import { splitHidden } from "./split-hidden.ts";

export interface ProjectOptions {
  /** About how many facets surfaces may have; 0 where a renderer draws the surfaces itself. */
  readonly facets: number;
}

/** Cells of the shadow on the ground, one flat tone, where the surface itself is drawn finely. */
const LIVE_SHADOW = 600;

/** How strongly what lies behind a surface still shows. */
const BEHIND = 0.32;

/**
 * The marks of a window into space as marks of the plane of its picture, in painting order: ground and shadow, surfaces
 * from far to near, what lies behind them faintly, then lines, points and letters.
 *
 * Lines are cut where they go behind a surface; arcs stay exact. Points become a little smaller with distance, and faint
 * behind a surface.
 */
export function project(marks: readonly Mark[], space: SpaceTransform, options: ProjectOptions): Mark[] {
  const patches = marks.filter((mark): mark is PatchMark => mark.kind === "patch");
  const samples = patches.map((patch) => projectSamples(patch, space));
  const behindBy = occlusion(patches, samples);
  const isHidden: IsHidden = (x, y, depth) => behindBy(x, y, depth) > 0;
  const shadowCells = options.facets === 0 ? LIVE_SHADOW : Math.max(64, options.facets / 8);
  const grounds = marks.filter((mark): mark is GroundMark => mark.kind === "ground");
  const ground = grounds.flatMap((one) => projectGround(one, patches, space, shadowCells));
  const surface: FacetsMark[] =
    patches.length === 0
      ? []
      : [
          {
            kind: "facets",
            key: "surfaces",
            role: "surface",
            patches,
            facets: options.facets > 0 ? facetsOf(patches, samples, space, options.facets, behindBy) : [],
          },
        ];
  const layers: Layers = { faint: [], lines: [], points: [], letters: [] };
  for (const mark of marks) place(mark, space, isHidden, layers);
  layers.points.sort((a, b) => a.depth - b.depth);
  // Seen from below, the ground lies in front.
  const fromAbove = space.axes.eye[2]! >= 0;
  return [
    ...(fromAbove ? ground : []),
    ...surface,
    ...(fromAbove ? [] : ground),
    ...layers.faint,
    ...layers.lines,
    ...layers.points.map(({ mark }) => mark),
    ...layers.letters,
  ];
}

interface Layers {
  readonly faint: Mark[];
  readonly lines: Mark[];
  readonly points: { mark: Mark; depth: number }[];
  readonly letters: Mark[];
}

function place(mark: Mark, space: SpaceTransform, isHidden: IsHidden, layers: Layers): void {
  switch (mark.kind) {
    case "path":
      placePath(mark, space, isHidden, layers);
      return;
    case "arrow":
      placeArrow(mark, space, isHidden, layers);
      return;
    case "point":
    case "disc": {
      const at = space.project(mark.at);
      const behind = isHidden(at[0], at[1], at[2]) ? { fade: BEHIND } : {};
      const scale = mark.kind === "point" ? { scale: nearness(at[2], space) } : {};
      layers.points.push({ mark: { ...mark, at: flat(at), ...behind, ...scale }, depth: at[2] });
      return;
    }
    case "label": {
      const at = space.project(mark.at);
      const behind = isHidden(at[0], at[1], at[2]) ? { fade: 0.6 } : {};
      const toward = mark.toward && directionOf(mark.at, mark.toward, space);
      const { toward: _, ...rest } = mark;
      layers.letters.push({ ...rest, at: flat(at), ...(toward ? { toward } : {}), ...behind });
      return;
    }
    case "patch":
    case "ground":
      return;
    case "raster":
    case "facets":
      throw new RangeError(`mark "${mark.key}": a ${mark.kind} has no place in space`);
    default: {
      const unknown: never = mark;
      throw new RangeError(`unknown kind of mark: ${JSON.stringify(unknown)}`);
    }
  }
}

const flat = (p: XY): XY => [p[0]!, p[1]!];

/** Points grow and shrink by a tenth over the depth of the window: enough to tell near from far. */
function nearness(depth: number, { plane }: SpaceTransform): number {
  const reach = (plane.x[1] - plane.x[0]) / 2;
  return 1 + 0.14 * Math.max(-1, Math.min(1, depth / reach));
}

function directionOf(at: XY, toward: XY, { project: to }: SpaceTransform): XY {
  const [from, tip] = [to(at), to(at.map((x, k) => x + toward[k]!))];
  return [tip[0] - from[0], tip[1] - from[1]];
}

function placePath(mark: PathMark, space: SpaceTransform, isHidden: IsHidden, layers: Layers): void {
  const { paint, ...line } = mark;
  if (paint === "fill" || paint === "both") {
    layers.lines.push({ ...line, paint: "fill", steps: projected(mark.steps, space) });
    if (paint === "fill") return;
  }
  const { seen, hidden } = splitHidden(mark.steps, space, isHidden);
  // The fine lines of a surface itself would only confuse from behind.
  if (hidden.length > 0 && mark.role !== "mesh" && mark.role !== "guide" && mark.role !== "grid") {
    layers.faint.push({ ...line, key: `${mark.key}-behind`, steps: hidden, fade: BEHIND });
  }
  if (seen.length > 0) layers.lines.push({ ...line, steps: seen });
}

function projected(steps: readonly PathStep[], { project: to }: SpaceTransform): PathStep[] {
  return steps.map((step) =>
    step[0] === "Z"
      ? step
      : ([step[0], ...(step.slice(1) as XY[]).map((p) => flat(to(p)))] as unknown as PathStep),
  );
}

/** An arrow keeps its head, faint if its tip is behind a surface; its shaft is cut like a line. */
function placeArrow(mark: ArrowMark, space: SpaceTransform, isHidden: IsHidden, layers: Layers): void {
  const [from, to] = [space.project(mark.from), space.project(mark.to)];
  const steps: PathStep[] = [
    ["M", mark.from],
    ["L", mark.to],
  ];
  const { seen, hidden } = splitHidden(steps, space, isHidden);
  if (hidden.length === 0) {
    layers.lines.push({ ...mark, from: flat(from), to: flat(to) });
    return;
  }
  const { from: _, to: __, kind: ___, ...shared } = mark;
  const end = seen.at(-1)?.at(-1) as XY | undefined;
  const reaches = end !== undefined && end[0] === to[0] && end[1] === to[1];
  if (reaches) {
    // The last piece that is seen carries the head, the others are plain lines.
    layers.faint.push({ ...shared, kind: "path", key: `${mark.key}-behind`, steps: hidden, fade: BEHIND });
    const start = seen.at(-2)!.at(-1) as XY;
    layers.lines.push({ ...mark, from: start, to: end });
    if (seen.length > 2)
      layers.lines.push({ ...shared, kind: "path", key: `${mark.key}-line`, steps: seen.slice(0, -2) });
  } else {
    layers.faint.push({ ...mark, from: flat(from), to: flat(to), fade: BEHIND });
    if (seen.length > 0) layers.lines.push({ ...shared, kind: "path", key: `${mark.key}-line`, steps: seen });
  }
}
