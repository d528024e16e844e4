import type { Param } from "../demo/param.ts";
import { wrapped } from "../demo/params/camera.ts";
import type { Camera } from "../scene/camera.ts";
import type { Core } from "./core.ts";
import { reducedMotion } from "./frame.ts";
import type { HandleLayer } from "./handle-layer.ts";
import { positionIn } from "./pointer.ts";
import type { Stage } from "./stage.ts";

/** Turning the view of a figure in space, with mouse, pen, fingers and wheel. */
export interface Orbit {
  /** Turns by angles in degrees and zooms by a factor, as one step for undo, or as a part of one. */
  turn(yaw: number, pitch: number, zoom: number, commit: boolean, time?: number): void;
  leave(): void;
  destroy(): void;
}

/** A drag across the shorter side of the window turns by so many degrees. */
const TURN = 170;
const TAP = 5;
/** Below this speed, in degrees a second, nothing goes on turning; the rest dies away in so many seconds. */
const LEAST_SPEED = 25;
const COAST = 0.55;
/** How long the wheel rests, in milliseconds, before its zoom counts as done. */
const WHEEL_REST = 250;

interface Finger {
  x: number;
  y: number;
  readonly startX: number;
  readonly startY: number;
  readonly size: number;
  moved: boolean;
}

/**
 * A mouse turns at once. A finger scrolls the page until the figure is entered by a tap on it; from then on one finger
 * turns and two zoom, until a tap elsewhere or Escape. The wheel belongs to the page too, unless Ctrl is held or the
 * figure is entered.
 */
export function createOrbit(core: Core, stage: Stage, layer: HandleLayer): Orbit {
  const { mover, store } = core;
  const param = core.demo.params.camera as Param<Camera>;
  const fingers = new Map<number, Finger>();
  let entered = false;
  let speed: readonly [number, number] = [0, 0];
  let lastTime = 0;
  let wheelRest: ReturnType<typeof setTimeout> | undefined;

  const camera = () => store.state.camera as Camera;
  const turned = ([yaw, pitch, distance]: Camera, byYaw: number, byPitch: number, zoom = 1): Camera =>
    param.round([wrapped(yaw + byYaw), pitch + byPitch, distance * zoom]);
  const turn: Orbit["turn"] = (yaw, pitch, zoom, commit, time) =>
    mover.put(
      "camera",
      turned(camera(), yaw, pitch, zoom),
      commit,
      time === undefined ? undefined : { kind: "camera", time },
    );
  const enter = (on: boolean) => {
    entered = on;
    stage.root.classList.toggle("is-entered", on);
  };

  const down = (event: PointerEvent) => {
    if (event.button !== 0 || stage.root.classList.contains("is-drawing")) return;
    const [x, y] = positionIn(stage.root, event);
    const window = stage.windowAt(x, y);
    if (!window || layer.nearest(x, y) !== null) return;
    if ((event.target as Element).closest(".views")) return;
    const { size } = window;
    fingers.set(event.pointerId, { x, y, startX: x, startY: y, size, moved: false });
    speed = [0, 0];
    if (event.pointerType !== "touch" || entered) {
      mover.stop();
      capture(stage.root, event.pointerId);
    }
  };
  const move = (event: PointerEvent) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return;
    const [x, y] = positionIn(stage.root, event);
    const [dx, dy] = [x - finger.x, y - finger.y];
    if (!finger.moved && Math.hypot(x - finger.startX, y - finger.startY) < TAP) return;
    finger.moved = true;
    if (event.pointerType === "touch" && !entered) return;
    const other = [...fingers.values()].find((one) => one !== finger);
    if (other) {
      const before = Math.hypot(finger.x - other.x, finger.y - other.y);
      const after = Math.hypot(x - other.x, y - other.y);
      if (before > 1 && after > 1) turn(0, 0, before / after, false);
    } else {
      const [yaw, pitch] = [(-dx * TURN) / finger.size, (dy * TURN) / finger.size];
      const seconds = Math.max(0.004, (event.timeStamp - lastTime) / 1000);
      speed = [yaw, pitch].map((angle, k) => 0.6 * (angle / seconds) + 0.4 * speed[k]!) as [number, number];
      turn(yaw, pitch, 1, false);
    }
    lastTime = event.timeStamp;
    [finger.x, finger.y] = [x, y];
  };
  const up = (event: PointerEvent) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return;
    fingers.delete(event.pointerId);
    if (!finger.moved) {
      // With a handle selected, the tap has put it here.
      if (!layer.selected) enter(true);
      return;
    }
    if (fingers.size > 0) return;
    if (event.pointerType === "touch" && !entered) return;
    const fresh = event.timeStamp - lastTime < 60;
    if (!fresh || reducedMotion() || Math.hypot(...speed) < LEAST_SPEED) return turn(0, 0, 1, true);
    const from = camera();
    const reach = speed.map((angle) => (Math.max(-600, Math.min(600, angle)) * COAST) / 3);
    mover.coast(COAST, (share) => {
      const way = 1 - (1 - share) ** 3;
      return { camera: turned(from, reach[0]! * way, reach[1]! * way) };
    });
  };
  const cancel = (event: PointerEvent) => {
    const finger = fingers.get(event.pointerId);
    fingers.delete(event.pointerId);
    if (finger?.moved && entered) turn(0, 0, 1, true);
  };
  const wheel = (event: WheelEvent) => {
    const [x, y] = positionIn(stage.root, event);
    if (!stage.windowAt(x, y) || !(event.ctrlKey || entered)) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
    turn(0, 0, Math.exp(Math.max(-120, Math.min(120, pixels)) * 0.002), false);
    clearTimeout(wheelRest);
    wheelRest = setTimeout(() => turn(0, 0, 1, true), WHEEL_REST);
  };
  const again = (event: MouseEvent) => {
    const [x, y] = positionIn(stage.root, event);
    if (!stage.windowAt(x, y) || layer.nearest(x, y) !== null) return;
    if ((event.target as Element).closest(".views")) return;
    mover.go({ camera: core.own().camera }, { source: "user", glide: true });
  };
  const outside = (event: PointerEvent) => {
    if (entered && !event.composedPath().includes(stage.root)) enter(false);
  };

  stage.root.addEventListener("pointerdown", down);
  stage.root.addEventListener("pointermove", move);
  stage.root.addEventListener("pointerup", up);
  stage.root.addEventListener("pointercancel", cancel);
  stage.root.addEventListener("wheel", wheel, { passive: false });
  stage.root.addEventListener("dblclick", again);
  document.addEventListener("pointerdown", outside);
  return {
    turn,
    leave: () => enter(false),
    destroy() {
      clearTimeout(wheelRest);
      document.removeEventListener("pointerdown", outside);
    },
  };
}

function capture(stage: HTMLElement, pointer: number): void {
  try {
    stage.setPointerCapture(pointer);
  } catch {
    // A pointer that was made by a script has no capture.
  }
}
