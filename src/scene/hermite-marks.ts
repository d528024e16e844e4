import { add, hermiteToBezier, norm, type Point, scale } from "../math/index.ts";
import { bezierSteps } from "./bezier-steps.ts";
import { arrow, label, path, point, polyline } from "./draw.ts";
import { wording } from "./label.ts";
import type { Mark, XY } from "./marks.ts";

/** A cubic Hermite segment as its four data. */
export interface Segment {
  readonly p0: XY;
  readonly m0: XY;
  readonly m1: XY;
  readonly p1: XY;
}

/** Tangents are drawn at a third of their length: the tip at p₀ is then the Bézier control point c₁. */
export const DRAWN = 1 / 3;

/** The lengths that the family of start tangents runs through, and the turns of both tangents in degrees. */
export const LENGTHS = [0, 1, 2, 3, 4, 5, 6];
export const TURNS = [-50, -25, 25, 50];

export const bezierOf = ({ p0, m0, m1, p1 }: Segment): Point[] => hermiteToBezier(p0, m0, m1, p1);

/** The drawing of the segment over [0, t]. */
export const segmentPath = (segment: Segment, t = 1) => bezierSteps(bezierOf(segment), [0, t]);

/** A tangent as an arrow from its point, a third as long: that of the curve with its index, any other as a ghost. */
export function tangentArrow(key: string, from: XY, vector: XY, index?: number): Mark[] {
  if (vector.every((x) => x === 0)) return [];
  const tip = add(from, scale(vector, DRAWN));
  return [
    index === undefined
      ? arrow(key, "ghost", from, tip)
      : arrow(key, "tangent", from, tip, { index, name: key }),
  ];
}

/** What else the curve could be: other lengths of the start tangent, each with its number. */
export function lengthFamily(segment: Segment): Mark[] {
  const { p0, m0 } = segment;
  const size = norm(m0);
  if (size === 0) return [];
  return LENGTHS.flatMap((length): Mark[] => {
    const tip = add(p0, scale(m0, (DRAWN * length) / size));
    return [
      path(`family-${length}`, "ghost", segmentPath({ ...segment, m0: scale(m0, length / size) })),
      point(`tick-${length}`, "ghost", tip, { size: "small", hollow: true }),
      ...(length > 0
        ? [label(`length-${length}`, "note", tip, wording({ de: `${length}`, en: `${length}` }))]
        : []),
    ];
  });
}

/** What else the curve could be: both tangents turned, the one to the left, the other to the right. */
export function directionFamily(segment: Segment): Mark[] {
  return TURNS.flatMap((degrees): Mark[] => {
    const [m0, m1] = [turned(segment.m0, degrees), turned(segment.m1, -degrees)];
    return [
      path(`family${degrees}`, "ghost", segmentPath({ ...segment, m0, m1 })),
      ...tangentArrow(`start${degrees}`, segment.p0, m0),
      ...tangentArrow(`end${degrees}`, segment.p1, m1),
    ];
  });
}

function turned([x, y]: XY, degrees: number): XY {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return [c * x! - s * y!, s * x! + c * y!];
}

/** The sum that makes the point: a place on the chord, then a share of each tangent, tip to tail. */
export function summands({ p0, m0, m1, p1 }: Segment, [h0, h1, h2, h3]: readonly number[]): Mark[] {
  const foot = add(scale(p0, h0!), scale(p1, h3!));
  const bend = add(foot, scale(m0, h1!));
  const to = add(bend, scale(m1, h2!));
  return [
    polyline("chord", "control-polygon", [p0, p1], { name: "chord" }),
    point("foot", "derived", foot, { size: "small", hollow: true, name: "foot" }),
    ...share("weights.1", foot, bend, 1),
    ...share("weights.2", bend, to, 2),
  ];
}

function share(name: string, from: XY, to: XY, index: number): Mark[] {
  const still = from.every((x, k) => x === to[k]);
  return still ? [] : [arrow(name, "derived", from, to, { index, name })];
}
