import type { XY } from "../scene/marks.ts";
import type { Box } from "../scene/view.ts";

/** Lettering that looks for its place. */
export interface LabelRequest {
  readonly at: XY;
  readonly width: number;
  readonly height: number;
  /** Radius that is taken at the point itself. */
  readonly clear: number;
  /** The preferred direction in pixels (y downwards); absent or zero: none. */
  readonly toward?: XY;
  /** Stands exactly on its point and is only kept clear of. */
  readonly fixed: boolean;
  /** Labels of a lower rank choose first. */
  readonly rank: number;
}

/** The box whose nearest point is `distance` from the label's point, in the given direction. */
export function boxAt(request: LabelRequest, angle: number, distance: number): Box {
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
  const [ax, ay] = [Math.abs(dx), Math.abs(dy)];
  const [a, b] = [request.width / 2, request.height / 2];
  const beside = (distance + a) / ax;
  const above = (distance + b) / ay;
  let reach: number;
  if (beside * ay <= b) reach = beside;
  else if (above * ax <= a) reach = above;
  else {
    // A corner is nearest: |(reach·ax − a, reach·ay − b)| = distance.
    const m = ax * a + ay * b;
    reach = m + Math.sqrt(Math.max(0, m * m - (a * a + b * b - distance * distance)));
  }
  return boxAround(request.at[0]! + dx * reach, request.at[1]! + dy * reach, request);
}

/** The box of a label whose middle is at the given place. */
export function boxAround(x: number, y: number, { width, height }: LabelRequest): Box {
  return { left: x - width / 2, top: y - height / 2, width, height };
}
