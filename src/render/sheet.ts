import type { LabelMark, Mark, PathStep, XY } from "../scene/marks.ts";
import type { Box, ViewTransform } from "../scene/view.ts";
import type { Obstacles } from "./obstacles.ts";
import type { Primitive } from "./primitives.ts";
import type { Part } from "./roles.ts";

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

export const isLit = (mark: Mark, { lit }: Sheet) => mark.name !== undefined && lit.has(mark.name);

/** Whether a place can be seen in the window. Not for what is not finite. */
export function inWindow([x, y]: XY, { left, top, width, height }: Box): boolean {
  return (
    x! >= left - POINT_BLEED &&
    x! <= left + width + POINT_BLEED &&
    y! >= top - POINT_BLEED &&
    y! <= top + height + POINT_BLEED
  );
}

export const isFinitePoint = (p: XY) => Number.isFinite(p[0]) && Number.isFinite(p[1]);

/** The window as a clip, unless all points of the steps lie in it (Bézier arcs stay in their hull). */
export function clipOf(steps: readonly PathStep[], { left, top, width, height }: Box): { clip?: Box } {
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
