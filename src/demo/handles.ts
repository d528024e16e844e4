import { label, point } from "../scene/draw.ts";
import type { Views } from "../scene/layout.ts";
import type { Mark, Scene, XY } from "../scene/marks.ts";
import type { Demo } from "./define.ts";
import type { Handle, Param, State } from "./param.ts";

/** A handle together with the parameter it changes. */
export interface BoundHandle extends Handle<unknown> {
  readonly param: string;
}

/** All handles of a figure in a state, in the order of the declaration. */
export function handlesOf(demo: Demo, state: State, views: Views = demo.views): BoundHandle[] {
  return Object.entries(demo.params).flatMap(([id, param]: [string, Param<unknown>]) =>
    param.handles(id, state[id], { state, views }).map((handle) => ({ ...handle, param: id })),
  );
}

/** The scene with its handles drawn on top: a point each, with its letter on the outer side. */
export function withHandles(scene: Scene, handles: readonly BoundHandle[]): Scene {
  const all: Record<string, readonly Mark[]> = { ...scene };
  for (const view of new Set(handles.map((handle) => handle.view))) {
    const group = handles.filter((handle) => handle.view === view);
    const middle = centre(group.map((handle) => handle.at));
    all[view] = [...(all[view] ?? []), ...group.flatMap((handle) => handleMarks(handle, middle))];
  }
  return all;
}

function handleMarks(handle: BoundHandle, middle: XY): Mark[] {
  const extra = { name: handle.id, ...(handle.index === undefined ? {} : { index: handle.index }) };
  const disc = point(`handle-${handle.id}`, "handle", handle.at, extra);
  if (!handle.lettered) return [disc];
  const toward = handle.at.map((x, k) => x - middle[k]!);
  return [disc, label(`letter-${handle.id}`, "handle", handle.at, handle.label, { ...extra, toward })];
}

function centre(points: readonly XY[]): XY {
  return points[0]!.map((_, k) => points.reduce((sum, p) => sum + p[k]!, 0) / points.length);
}
