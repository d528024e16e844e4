import type { DiscMark, PointMark } from "../scene/marks.ts";
import type { Box } from "../scene/view.ts";
import { COVERED } from "./obstacles.ts";
import type { Part } from "./roles.ts";
import { shapeOf, shapeSteps } from "./shapes.ts";
import { base, clipOf, inWindow, isLit, type Sheet } from "./sheet.ts";
import { SIZE } from "./sizes.ts";

/** A point: full, hollow or a handle with its ring; its shape tells its index. */
export function drawPoint(mark: PointMark, sheet: Sheet): void {
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
  sheet.obstacles.circles.push({
    x: at[0],
    y: at[1],
    r: radius + 1,
    price: handle ? COVERED.handle : COVERED.point,
  });
}

/** The radius that shows the weight 1, in pixels. */
function discUnit({ width, height }: Box): number {
  return Math.min(52, Math.max(26, 0.1 * Math.min(width, 1.6 * height)));
}

/** A disc may reach so far beyond its window before the window cuts it. */
const DISC_BLEED = 8;

function cut([x, y]: readonly [number, number], r: number, box: Box): { clip?: Box } {
  return clipOf(
    [
      ["M", [x - r, y - r]],
      ["L", [x + r, y + r]],
    ],
    box,
  );
}

/** The disc of a weight: its area is the weight's amount; hollow and with a minus where it is negative. */
export function drawDisc(mark: DiscMark, sheet: Sheet): void {
  const at = sheet.transform.toPixel(mark.at);
  const { box } = sheet.transform;
  if (!inWindow(at, box) || !Number.isFinite(mark.weight) || mark.weight === 0) return;
  const radius = discUnit(box) * Math.sqrt(Math.abs(mark.weight));
  const circle = { kind: "circle", at, radius, ...cut(at, radius - DISC_BLEED, box) } as const;
  if (isLit(mark, sheet)) sheet.primitives.push({ ...base(mark, "shine"), ...circle, radius: radius + 5 });
  sheet.obstacles.circles.push({ x: at[0], y: at[1], r: radius, price: COVERED.disc });
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
  sheet.obstacles.circles.push({ x: badge[0], y: badge[1], r: 7, price: COVERED.point });
}
