import type { HandleLayer } from "./handle-layer.ts";

/** What the pointer does to the figure; positions in CSS pixels of the stage, y downwards. */
export interface PointerTarget {
  /** Where a handle is now, or null if it is gone. */
  where(id: string): readonly [number, number] | null;
  move(id: string, x: number, y: number, commit: boolean): void;
  cancel(): void;
  /** The pencil is on: strokes instead of handles. */
  readonly drawing: boolean;
  draw(x: number, y: number, phase: "start" | "move" | "end"): void;
}

interface Drag {
  readonly id: string | null; // null: a tap on the empty stage, or a stroke
  readonly grabX: number;
  readonly grabY: number;
  readonly startX: number;
  readonly startY: number;
  moved: boolean;
}

/** Fingers tremble: less than this is a tap. */
const TAP = 5;

/**
 * Mouse, pen and fingers on the stage. The nearest handle wins where several overlap; two fingers move two
 * handles; a tap selects a handle, and a tap elsewhere puts the selected handle there.
 */
export function listenToPointer(stage: HTMLElement, layer: HandleLayer, target: PointerTarget): void {
  const drags = new Map<number, Drag>();

  const position = (event: PointerEvent) => positionIn(stage, event);

  stage.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    const [x, y] = position(event);
    const id = target.drawing ? null : layer.nearest(x, y);
    const at = id ? target.where(id) : null;
    drags.set(event.pointerId, {
      id,
      grabX: at ? x - at[0] : 0,
      grabY: at ? y - at[1] : 0,
      startX: x,
      startY: y,
      moved: false,
    });
    if (id) {
      // The button that was hit need not be the nearest one: the focus goes to what is moved.
      event.preventDefault();
      const button = layer.elementOf(id);
      button?.focus({ preventScroll: true });
      button?.classList.add("is-dragged");
    }
    if (id || target.drawing) capture(stage, event.pointerId);
    if (target.drawing) target.draw(x, y, "start");
  });

  stage.addEventListener("pointermove", (event) => {
    const drag = drags.get(event.pointerId);
    if (!drag) return;
    const [x, y] = position(event);
    if (Math.hypot(x - drag.startX, y - drag.startY) > TAP) drag.moved = true;
    if (target.drawing && !drag.id) target.draw(x, y, "move");
    else if (drag.id && drag.moved) target.move(drag.id, x - drag.grabX, y - drag.grabY, false);
  });

  const finish = (event: PointerEvent, cancelled: boolean) => {
    const drag = drags.get(event.pointerId);
    if (!drag) return;
    drags.delete(event.pointerId);
    const [x, y] = position(event);
    if (drag.id) layer.elementOf(drag.id)?.classList.remove("is-dragged");
    if (cancelled) return target.cancel();
    if (target.drawing && !drag.id) return target.draw(x, y, "end");
    if (drag.id && drag.moved) return target.move(drag.id, x - drag.grabX, y - drag.grabY, true);
    if (drag.moved) return;
    if (drag.id) return layer.select(layer.selected === drag.id ? null : drag.id);
    if (layer.selected) target.move(layer.selected, x, y, true);
  };
  stage.addEventListener("pointerup", (event) => finish(event, false));
  stage.addEventListener("pointercancel", (event) => finish(event, true));
}

/** Position in the stage, whatever scale the host puts on it: the one place where this is worked out. */
export function positionIn(stage: HTMLElement, event: MouseEvent): readonly [number, number] {
  const rect = stage.getBoundingClientRect();
  return [
    ((event.clientX - rect.left) * stage.clientWidth) / rect.width,
    ((event.clientY - rect.top) * stage.clientHeight) / rect.height,
  ];
}

function capture(stage: HTMLElement, pointer: number): void {
  try {
    stage.setPointerCapture(pointer);
  } catch {
    // A pointer that was made by a script has no capture; the drag works inside the stage all the same.
  }
}
