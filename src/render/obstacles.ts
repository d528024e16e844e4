import type { PathStep } from "../scene/marks.ts";

/** Something round, and what it costs to cover it, in pixels of detour. */
export interface Round {
  readonly x: number;
  readonly y: number;
  readonly r: number;
  readonly price: number;
}

/** Handles are never covered; points where it can be helped; through a disc letters are still read. */
export const COVERED = { handle: Number.POSITIVE_INFINITY, point: 40, disc: 5 };

/** What lettering keeps away from, in pixels. */
export interface Obstacles {
  /** Points and discs. */
  readonly circles: Round[];
  /** Straight pieces of lines, four numbers each, with a weight as the fifth. */
  readonly lines: number[];
}

/** Length of the straight pieces that stand for a Bézier arc, in pixels. */
const PIECE = 22;

/** Adds a path's line to the obstacles. `weight` 1 for what matters most. */
export function addLine(lines: number[], steps: readonly PathStep[], weight: number): void {
  let [x, y, startX, startY] = [0, 0, 0, 0];
  const to = (nextX: number, nextY: number) => {
    lines.push(x, y, nextX, nextY, weight);
    [x, y] = [nextX, nextY];
  };
  for (const step of steps) {
    switch (step[0]) {
      case "M":
        [x, y] = [step[1][0]!, step[1][1]!];
        [startX, startY] = [x, y];
        break;
      case "L":
        to(step[1][0]!, step[1][1]!);
        break;
      case "Z":
        to(startX, startY);
        break;
      case "Q":
      case "C":
        addArc(step, x, y, to);
        break;
    }
  }
}

function addArc(
  step: Extract<PathStep, readonly ["Q" | "C", ...unknown[]]>,
  x0: number,
  y0: number,
  to: (x: number, y: number) => void,
): void {
  const end = step[0] === "C" ? step[3] : step[2];
  const [x1, y1] = [step[1][0]!, step[1][1]!];
  const [x2, y2] = step[0] === "C" ? [step[2][0]!, step[2][1]!] : [x1, y1];
  const [x3, y3] = [end[0]!, end[1]!];
  const length = Math.hypot(x1 - x0, y1 - y0) + Math.hypot(x2 - x1, y2 - y1) + Math.hypot(x3 - x2, y3 - y2);
  const count = Math.min(24, Math.max(1, Math.ceil(length / PIECE)));
  for (let i = 1; i <= count; i++) {
    const t = i / count;
    const s = 1 - t;
    if (step[0] === "C") {
      const [a, b, c, d] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
      to(a * x0 + b * x1 + c * x2 + d * x3, a * y0 + b * y1 + c * y2 + d * y3);
    } else {
      const [a, b, c] = [s * s, 2 * s * t, t * t];
      to(a * x0 + b * x1 + c * x3, a * y0 + b * y1 + c * y3);
    }
  }
}
