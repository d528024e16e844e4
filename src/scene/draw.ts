import type { Label } from "./label.ts";
import type { ArrowMark, DiscMark, LabelMark, PathMark, PathStep, PointMark, Role, XY } from "./marks.ts";

/** What any mark may carry besides its geometry. */
type Extra = { readonly index?: number; readonly name?: string };

/** A path from its steps. */
export function path(
  key: string,
  role: Role,
  steps: readonly PathStep[],
  extra: Extra & Pick<PathMark, "paint"> = {},
): PathMark {
  return { kind: "path", key, role, steps, ...extra };
}

/** The open polygon through the points. */
export function polyline(key: string, role: Role, points: readonly XY[], extra: Extra = {}): PathMark {
  return path(key, role, lineSteps(points), extra);
}

/** The filled region with the given corners. */
export function region(key: string, role: Role, corners: readonly XY[], extra: Extra = {}): PathMark {
  return path(key, role, [...lineSteps(corners), ["Z"]], { paint: "fill", ...extra });
}

function lineSteps(points: readonly XY[]): PathStep[] {
  return points.map((point, i) => [i === 0 ? "M" : "L", point] as const);
}

export function point(
  key: string,
  role: Role,
  at: XY,
  extra: Extra & Pick<PointMark, "size" | "hollow"> = {},
): PointMark {
  return { kind: "point", key, role, at, ...extra };
}

export function disc(key: string, at: XY, weight: number, extra: Extra = {}): DiscMark {
  return { kind: "disc", key, role: "weight", at, weight, ...extra };
}

export function arrow(key: string, role: Role, from: XY, to: XY, extra: Extra = {}): ArrowMark {
  return { kind: "arrow", key, role, from, to, ...extra };
}

export function label(
  key: string,
  role: Role,
  at: XY,
  text: Label,
  extra: Extra & Pick<LabelMark, "place" | "toward"> = {},
): LabelMark {
  return { kind: "label", key, role, at, label: text, ...extra };
}
