import type { LabelRequest } from "./label-request.ts";
import type { Obstacles } from "./obstacles.ts";

/** How far the surroundings of a point reach when its free side is looked for, in pixels. */
const SIGHT = 80;
/** Width of the rim where a line begins to count: what passes through the point itself pulls to no side. */
const RIM = 20;
/** Lines are looked at in pieces of this length. */
const PIECE = 5;

/**
 * The direction away from the lines around a point, weighted by their length and nearness. It turns steadily
 * when the lines move steadily, so that lettering does not flutter. Where nothing is near, to the upper
 * right: where a reader looks for a name.
 */
export function freeSide({ at, clear }: LabelRequest, { lines, circles }: Obstacles): number {
  const [x, y] = [at[0]!, at[1]!];
  // The wish for the upper right is weak, but never zero.
  let [pushX, pushY] = [4, -4];
  const away = (fromX: number, fromY: number, weight: number) => {
    const [dx, dy] = [x - fromX, y - fromY];
    const distance = Math.hypot(dx, dy);
    if (distance <= clear || distance >= SIGHT) return;
    const rim = Math.min(1, (distance - clear) / RIM);
    const push = (weight * rim * rim * (1 - distance / SIGHT) ** 2) / distance;
    pushX += dx * push;
    pushY += dy * push;
  };
  for (let i = 0; i < lines.length; i += 5) {
    const [x0, y0, x1, y1] = [lines[i]!, lines[i + 1]!, lines[i + 2]!, lines[i + 3]!];
    const length = Math.hypot(x1 - x0, y1 - y0);
    const count = Math.min(100, Math.max(1, Math.ceil(length / PIECE)));
    for (let k = 0; k < count; k++) {
      const share = (k + 0.5) / count;
      away(x0 + (x1 - x0) * share, y0 + (y1 - y0) * share, (length / count) * lines[i + 4]!);
    }
  }
  for (const circle of circles) away(circle.x, circle.y, Math.min(30, circle.price));
  return Math.atan2(pushY, pushX);
}
