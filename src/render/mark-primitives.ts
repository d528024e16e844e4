import type {
  ArrowMark,
  DiscMark,
  FacetsMark,
  LabelMark,
  Mark,
  PathMark,
  PathStep,
  PointMark,
  RasterMark,
  XY,
} from "../scene/marks.ts";
import type { Box, ViewTransform } from "../scene/view.ts";
import { arrow } from "./arrow.ts";
import { levelOf } from "./colour-map.ts";
import { addLine, type Obstacles } from "./obstacles.ts";
import type { Primitive } from "./primitives.ts";
import type { Part } from "./roles.ts";
import { shapeOf, shapeSteps } from "./shapes.ts";
import { SIZE } from "./sizes.ts";

/** The sheet on which a window's marks are drawn. */
export interface Sheet {
  readonly transform: ViewTransform;
  readonly lit: ReadonlySet<string>;
  readonly primitives: Primitive[];
  readonly obstacles: Obstacles;
  /** The boxes of the weights' filled regions. */
  readonly regions: Box[];
  /** Lettering is set once everything else stands. */
  readonly labels: LabelMark[];
}

/** Adds a mark to the sheet. The only place that knows the kinds of marks. */
export function drawMark(mark: Mark, sheet: Sheet): void {
  switch (mark.kind) {
    case "path":
      drawPath(mark, sheet);
      return;
    case "point":
      drawPoint(mark, sheet);
      return;
    case "disc":
      drawDisc(mark, sheet);
      return;
    case "arrow":
      drawArrow(mark, sheet);
      return;
    case "label":
      sheet.labels.push(mark);
      return;
    case "raster":
      drawRaster(mark, sheet);
      return;
    case "facets":
      drawFacets(mark, sheet);
      return;
    case "patch":
    case "ground":
      throw new RangeError(`mark "${mark.key}": a ${mark.kind} needs a view into space (spaceView)`);
    default: {
      const unknown: never = mark;
      throw new RangeError(`unknown kind of mark: ${JSON.stringify(unknown)}`);
    }
  }
}

/** Lines keep half their width at the edge of the window; a point is seen whole or not at all. */
const BLEED = 2;
const POINT_BLEED = 4;

/** What all primitives of a mark share. */
export function base<P extends Part>(mark: Mark, part: P) {
  return {
    role: mark.role,
    part,
    ...(mark.index === undefined ? {} : { index: mark.index }),
    ...(mark.fade === undefined ? {} : { opacity: mark.fade }),
  };
}

const isLit = (mark: Mark, { lit }: Sheet) => mark.name !== undefined && lit.has(mark.name);

/** Whether a place can be seen in the window. Not for what is not finite. */
export function inWindow([x, y]: XY, { left, top, width, height }: Box): boolean {
  return (
    x! >= left - POINT_BLEED &&
    x! <= left + width + POINT_BLEED &&
    y! >= top - POINT_BLEED &&
    y! <= top + height + POINT_BLEED
  );
}

const isFinitePoint = (p: XY) => Number.isFinite(p[0]) && Number.isFinite(p[1]);

/** The steps in pixels. What is not finite is left out, and the path starts again behind it. */
function toPixels(steps: readonly PathStep[], { toPixel }: ViewTransform): PathStep[] {
  const mapped: PathStep[] = [];
  let broken = false;
  for (const step of steps) {
    if (step[0] === "Z") {
      if (!broken && mapped.length > 0) mapped.push(step);
      continue;
    }
    const points = (step.slice(1) as XY[]).map(toPixel);
    if (!points.every(isFinitePoint)) {
      broken = true;
    } else if (broken || mapped.length === 0) {
      mapped.push(["M", points.at(-1)!]);
      broken = false;
    } else {
      mapped.push([step[0], ...points] as unknown as PathStep);
    }
  }
  return mapped;
}

/** The window as a clip, unless all points of the steps lie in it (Bézier arcs stay in their hull). */
function clipOf(steps: readonly PathStep[], { left, top, width, height }: Box): { clip?: Box } {
  for (const step of steps) {
    for (let i = 1; i < step.length; i++) {
      const [x, y] = step[i] as XY;
      if (x! < left - BLEED || x! > left + width + BLEED || y! < top - BLEED || y! > top + height + BLEED) {
        return {
          clip: {
            left: left - BLEED,
            top: top - BLEED,
            width: width + 2 * BLEED,
            height: height + 2 * BLEED,
          },
        };
      }
    }
  }
  return {};
}

/** The box of all points of the steps. */
function boxOf(steps: readonly PathStep[]): Box {
  const points = steps.flatMap((step) => step.slice(1) as XY[]);
  const [xs, ys] = [points.map((p) => p[0]!), points.map((p) => p[1]!)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  return { left, top, width: Math.max(...xs) - left, height: Math.max(...ys) - top };
}

/** How much lettering avoids the lines of a role. */
function lineWeight(mark: Mark): number {
  if (mark.role === "curve" || mark.role === "good" || mark.role === "bad") return 1.6;
  return mark.role === "guide" || mark.role === "ghost" || mark.role === "grid" ? 0.5 : 1;
}

function drawPath(mark: PathMark, sheet: Sheet): void {
  const steps = toPixels(mark.steps, sheet.transform);
  if (steps.length < 2) return;
  const shared = { kind: "path", steps, ...clipOf(steps, sheet.transform.box) } as const;
  const paint = mark.paint ?? "stroke";
  if (isLit(mark, sheet)) {
    sheet.primitives.push({ ...base(mark, paint === "fill" ? "shine" : "glow"), ...shared });
  }
  if (paint !== "stroke") {
    sheet.primitives.push({ ...base(mark, "area"), ...shared });
    if (mark.role === "weight") sheet.regions.push(boxOf(steps));
  }
  if (paint !== "fill") {
    sheet.primitives.push({ ...base(mark, "line"), ...shared });
    addLine(sheet.obstacles.lines, steps, lineWeight(mark));
  }
}

function drawPoint(mark: PointMark, sheet: Sheet): void {
  const at = sheet.transform.toPixel(mark.at);
  if (!inWindow(at, sheet.transform.box)) return;
  const handle = mark.role === "handle";
  const scale = mark.scale ?? 1;
  const radius = scale * (handle ? SIZE.ring : mark.size === "small" ? SIZE.smallPoint : SIZE.point);
  const circle = (part: Part, r: number) =>
    sheet.primitives.push({ kind: "circle", ...base(mark, part), at, radius: r });
  if (isLit(mark, sheet)) circle("shine", radius + 7);
  if (handle) circle("ring", radius);
  if (mark.hollow && !handle) {
    circle("hollow", radius);
  } else {
    const shape = mark.size === "small" ? "disc" : shapeOf(mark.index);
    const part = handle ? "solid" : "point";
    const r = handle ? scale * SIZE.shape : radius;
    if (shape === "disc") circle(part, r);
    else sheet.primitives.push({ kind: "path", ...base(mark, part), steps: shapeSteps(shape, at, r) });
  }
  sheet.obstacles.circles.push({ x: at[0], y: at[1], r: radius + 1, hard: handle });
}

/** The radius that shows the weight 1, in pixels. */
function discUnit({ width, height }: Box): number {
  return Math.min(52, Math.max(26, 0.1 * Math.min(width, 1.6 * height)));
}

function drawDisc(mark: DiscMark, sheet: Sheet): void {
  const at = sheet.transform.toPixel(mark.at);
  const { box } = sheet.transform;
  if (!inWindow(at, box) || !Number.isFinite(mark.weight) || mark.weight === 0) return;
  const radius = discUnit(box) * Math.sqrt(Math.abs(mark.weight));
  const circle = { kind: "circle", at, radius } as const;
  if (isLit(mark, sheet)) sheet.primitives.push({ ...base(mark, "shine"), ...circle, radius: radius + 5 });
  sheet.obstacles.circles.push({ x: at[0], y: at[1], r: radius, hard: false });
  if (mark.weight > 0) {
    sheet.primitives.push({ ...base(mark, "disc"), ...circle });
    return;
  }
  sheet.primitives.push({ ...base(mark, "outline"), ...circle });
  // The minus sits on the rim, outside the ring of a handle, however small the weight is.
  const reach = Math.max(radius, SIZE.ring + 8) * Math.SQRT1_2;
  const badge = [at[0] + reach, at[1] + reach] as const;
  sheet.primitives.push({ kind: "circle", ...base(mark, "hollow"), at: badge, radius: 6 });
  const steps = [["M", [badge[0] - 3, badge[1]]] as const, ["L", [badge[0] + 3, badge[1]]] as const];
  sheet.primitives.push({ kind: "path", ...base(mark, "outline"), steps });
  sheet.obstacles.circles.push({ x: badge[0], y: badge[1], r: 7, hard: false });
}

function drawArrow(mark: ArrowMark, sheet: Sheet): void {
  const from = sheet.transform.toPixel(mark.from);
  const to = sheet.transform.toPixel(mark.to);
  if (!isFinitePoint(from) || !isFinitePoint(to)) return;
  const drawn = arrow(from, to);
  if (!drawn) {
    // A vector without length is a point.
    if (inWindow(from, sheet.transform.box))
      sheet.primitives.push({ kind: "circle", ...base(mark, "solid"), at: from, radius: 2.5 });
    return;
  }
  const clip = clipOf([...drawn.shaft, ...drawn.head], sheet.transform.box);
  const path = (part: Part, steps: readonly PathStep[]) =>
    sheet.primitives.push({ kind: "path", ...base(mark, part), steps, ...clip });
  if (isLit(mark, sheet))
    path("glow", [
      ["M", from],
      ["L", to],
    ]);
  path("line", drawn.shaft);
  path("solid", drawn.head);
  addLine(
    sheet.obstacles.lines,
    [
      ["M", from],
      ["L", to],
    ],
    1,
  );
}

function drawFacets(mark: FacetsMark, { primitives, transform }: Sheet): void {
  const { space } = transform;
  if (!space) throw new RangeError(`mark "${mark.key}": facets belong to a view into space`);
  const facets = mark.facets.map(({ corners, colour }) => ({
    corners: corners.map((corner) => space.plane.toPixel(corner)),
    colour,
  }));
  const clip = clipOf(
    facets.flatMap(({ corners }) => corners.map((corner) => ["L", corner] as const)),
    transform.box,
  );
  primitives.push({ kind: "facets", ...base(mark, "solid"), facets, patches: mark.patches, space, ...clip });
}

function drawRaster(mark: RasterMark, sheet: Sheet): void {
  const { columns, rows, values, range } = mark;
  const [left, bottom] = sheet.transform.toPixel([mark.x[0], mark.y[0]]);
  const [right, top] = sheet.transform.toPixel([mark.x[1], mark.y[1]]);
  if (!isFinitePoint([left, bottom]) || !isFinitePoint([right, top]) || columns < 1 || rows < 1) return;
  const levels = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      levels[(rows - 1 - row) * columns + column] = levelOf(
        values[row * columns + column] ?? Number.NaN,
        range,
      );
    }
  }
  sheet.primitives.push({
    kind: "raster",
    ...base(mark, "solid"),
    key: mark.key,
    box: { left, top, width: right - left, height: bottom - top },
    columns,
    rows,
    levels,
    colours: mark.colours,
    ...clipOf(
      [
        ["M", [left, top]],
        ["L", [right, bottom]],
      ],
      sheet.transform.box,
    ),
  });
}
