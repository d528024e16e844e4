import type { ArrowMark, Mark, PathMark, PathStep, XY } from "../scene/marks.ts";
import type { Box, ViewTransform } from "../scene/view.ts";
import { arrow } from "./arrow.ts";
import { addLine } from "./obstacles.ts";
import type { Part } from "./roles.ts";
import { base, clipOf, inWindow, isFinitePoint, isLit, type Sheet } from "./sheet.ts";

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

/** A path as line, region or both, cut by its window where it leaves it. */
export function drawPath(mark: PathMark, sheet: Sheet): void {
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

/** A vector with its head; one without length is a small dot. */
export function drawArrow(mark: ArrowMark, sheet: Sheet): void {
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
