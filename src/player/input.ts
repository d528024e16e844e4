import type { Core } from "./core.ts";
import type { HandleLayer } from "./handle-layer.ts";
import type { Pencil } from "./pencil.ts";
import { listenToPointer } from "./pointer.ts";
import { arrowOf, commandOf, factorOf } from "./shortcuts.ts";
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
  listenToPointer(stage.root, layer, {
    where: (id) => {
      const handle = handleById(id);
      return handle ? stage.toStage(handle.view, handle.at) : null;
    },
    move: (id, x, y, commit) => {
      const handle = handleById(id);
      const to = handle && stage.toWorld(handle.view, x, y);
      if (to) mover.put(handle.param, handle.put(to), commit);
    },
    cancel: () => store.cancel(),
    get drawing() {
      return pencil?.on ?? false;
    },
    draw: (x, y, phase) => pencil?.draw(x, y, phase),
  });

  const nudge = (
    id: string | undefined,
    direction: readonly [number, number],
    factor: number,
    time?: number,
  ) => {
    const handle = id === undefined ? undefined : handleById(id);
    if (!handle) return;
    const merge = time === undefined ? undefined : { kind: handle.id, time };
    mover.put(handle.param, handle.nudge(direction, factor), true, merge);
  };
  shell.addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    const focused = target.closest<HTMLElement>("[data-handle]");
    const typing = target instanceof HTMLInputElement && target.type === "text";
    const arrow = focused && arrowOf(event);
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
        if (!arrow) return;
        nudge(focused.dataset.handle, arrow, factorOf(event), event.timeStamp);
    }
    event.preventDefault();
  });
  return {
    nudgeSelected: (direction) => nudge(layer.selected ?? core.figure.handles[0]?.id, direction, 1),
  };
}
