import type { XY } from "../scene/marks.ts";
import type { Core } from "./core.ts";
import type { HandleLayer } from "./handle-layer.ts";
import type { Pencil } from "./pencil.ts";
import { listenToPointer } from "./pointer.ts";
import { arrowOf, commandOf, depthOf, factorOf } from "./shortcuts.ts";
import type { Stage } from "./stage.ts";

export interface Input {
  /** Moves the selected handle, or the first one, as an arrow key would. */
  nudgeSelected(direction: readonly [number, number]): void;
}

/** Mouse, touch and keys, all ending in the same call: a new value for the handle's parameter. */
export function listen(
  shell: HTMLElement,
  core: Core,
  stage: Stage,
  layer: HandleLayer,
  pencil: Pencil | null,
): Input {
  const { store, mover } = core;
  const handleById = (id: string) => core.figure.handles.find((handle) => handle.id === id);
  const drags = new Map<string, XY>();
  listenToPointer(stage.root, layer, {
    where: (id) => {
      const handle = handleById(id);
      return handle ? stage.toStage(handle.view, handle.at) : null;
    },
    move: (id, x, y, commit) => {
      const handle = handleById(id);
      if (!handle) return;
      // In space, the whole drag stays in the plane in which it began, whatever rounding does on the way.
      const through = drags.get(id) ?? handle.at;
      if (commit) drags.delete(id);
      else drags.set(id, through);
      const to = stage.toWorld(handle.view, x, y, through);
      if (to) mover.put(handle.param, handle.put(to), commit);
    },
    cancel: () => {
      drags.clear();
      store.cancel();
    },
    get drawing() {
      return pencil?.on ?? false;
    },
    draw: (x, y, phase) => pencil?.draw(x, y, phase),
  });

  /** A direction of the picture, right and up and towards the eye, in the axes of the handle's view. */
  const inView = (view: string, [right, up, near = 0]: XY): XY => {
    const space = stage.spaceOf(view);
    if (!space) return [right!, up!];
    const { axes } = space;
    return axes.eye.map((eye, k) => right! * axes.right[k]! + up! * axes.up[k]! + near * eye);
  };
  const nudge = (id: string | undefined, direction: XY, factor: number, time?: number) => {
    const handle = id === undefined ? undefined : handleById(id);
    if (!handle) return;
    const merge = time === undefined ? undefined : { kind: handle.id, time };
    mover.put(handle.param, handle.nudge(inView(handle.view, direction), factor), true, merge);
  };
  const inSpace = (id: string | undefined) => {
    const view = id === undefined ? undefined : handleById(id)?.view;
    return view !== undefined && stage.spaceOf(view) !== null;
  };
  shell.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    const focused = target.closest<HTMLElement>("[data-handle]");
    const typing = target instanceof HTMLInputElement && target.type === "text";
    const arrow = focused && (arrowOf(event) ?? depthOf(event, core.embedded));
    switch (commandOf(event, focused !== null)) {
      case "undo":
        if (typing) return;
        mover.travel(store.undo);
        break;
      case "redo":
        if (typing) return;
        mover.travel(store.redo);
        break;
      case "play":
        mover.play(!mover.moving);
        break;
      case "leave":
        store.cancel();
        layer.select(null);
        target.blur();
        return;
      default:
        if (!arrow || (arrow.length > 2 && !inSpace(focused.dataset.handle))) return;
        nudge(focused.dataset.handle, arrow, factorOf(event), event.timeStamp);
    }
    event.preventDefault();
  });
  return {
    nudgeSelected: (direction) => nudge(layer.selected ?? core.figure.handles[0]?.id, direction, 1),
  };
}
