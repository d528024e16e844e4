import type { Core } from "./core.ts";
import type { HandleLayer } from "./handle-layer.ts";
import { markAt } from "./hit.ts";
import { positionIn } from "./pointer.ts";
import type { Stage } from "./stage.ts";

/**
 * Tells what is pointed at in the figure, by its name: the handle or slider that has the focus or is dragged, the mark
 * under the pointer. `changed` is called only when that changes; between, nothing runs.
 */
export function listenToPointing(
  shell: HTMLElement,
  core: Core,
  stage: Stage,
  layer: HandleLayer,
  changed: (names: readonly string[]) => void,
): void {
  let hovered: string | null = null;
  let focused: string | null = null;
  let told = "";
  const tell = () => {
    const names = [...new Set([hovered, focused])].filter((name) => name !== null);
    const now = names.join("\n");
    if (now === told) return;
    told = now;
    changed(names);
  };
  const nameOf = (target: EventTarget | null): string | null => {
    const element = (target as HTMLElement | null)?.closest<HTMLElement>("[data-handle], [data-param]");
    return element?.dataset.handle ?? element?.dataset.param ?? null;
  };
  shell.addEventListener("focusin", (event) => {
    focused = nameOf(event.target);
    tell();
  });
  shell.addEventListener("focusout", () => {
    focused = null;
    tell();
  });
  shell.addEventListener("pointermove", (event) => {
    // During a drag the hand is on what has the focus, wherever the pointer is.
    if (event.buttons !== 0) hovered = null;
    else if (stage.root.contains(event.target as Node)) {
      const [x, y] = positionIn(stage.root, event);
      const handles = new Set(core.figure.handles.map(({ id }) => id));
      hovered = layer.nearest(x, y) ?? markAt(core.figure, x, y, stage.toStage, handles);
    } else hovered = nameOf(event.target);
    tell();
  });
  shell.addEventListener("pointerleave", () => {
    hovered = null;
    tell();
  });
}
