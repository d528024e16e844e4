import type { Box } from "../scene/view.ts";

/** Whether a box lies in another one. */
export function inside(box: Box, bounds: Box): boolean {
  return (
    box.left >= bounds.left &&
    box.top >= bounds.top &&
    box.left + box.width <= bounds.left + bounds.width &&
    box.top + box.height <= bounds.top + bounds.height
  );
}

/** Whether two boxes come nearer than `gap` to each other. */
export function overlap(a: Box, b: Box, gap: number): boolean {
  return (
    a.left < b.left + b.width + gap &&
    b.left < a.left + a.width + gap &&
    a.top < b.top + b.height + gap &&
    b.top < a.top + a.height + gap
  );
}

/** How much of a straight piece runs through a box (the method of Liang and Barsky). */
export function lengthInside(box: Box, x0: number, y0: number, x1: number, y1: number): number {
  const [dx, dy] = [x1 - x0, y1 - y0];
  let from = 0;
  let to = 1;
  const cut = (direction: number, room: number): boolean => {
    if (direction === 0) return room >= 0;
    const t = room / direction;
    if (direction < 0) from = Math.max(from, t);
    else to = Math.min(to, t);
    return from <= to;
  };
  const meets =
    cut(-dx, x0 - box.left) &&
    cut(dx, box.left + box.width - x0) &&
    cut(-dy, y0 - box.top) &&
    cut(dy, box.top + box.height - y0);
  return meets ? (to - from) * Math.hypot(dx, dy) : 0;
}
