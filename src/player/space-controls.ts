import { viewpoint } from "../demo/describe-camera.ts";
import { type Camera, FLAT, type FlatView, flatView } from "../scene/camera.ts";
import type { Core } from "./core.ts";
import { element } from "./element.ts";
import type { HandleLayer } from "./handle-layer.ts";
import { createOrbit } from "./orbit.ts";
import { arrowOf, factorOf } from "./shortcuts.ts";
import type { Stage } from "./stage.ts";
import { joinSurfacePainter, type SurfacePainter } from "./surface-painter.ts";
import { WORDS } from "./words.ts";

/** What a figure has for looking around in space, beside its handles. */
export interface SpaceControls {
  /** Lies below the handles: takes the focus, so that keys can turn the view. */
  readonly under: readonly HTMLElement[];
  /** Lies above them: the buttons of the views. */
  readonly over: readonly HTMLElement[];
  readonly painter: SurfacePainter | null;
  update(): void;
  destroy(): void;
}

/** Degrees that an arrow key turns. */
const STEP = 5;
const ZOOM = 1.12;

/** The controls of a figure with a window into space; null for others. */
export function createSpaceControls(core: Core, stage: Stage, layer: HandleLayer): SpaceControls | null {
  const { demo, options, mover, store } = core;
  if (!Object.values(demo.views).some((view) => view.space)) return null;
  const { lang, still, controls } = options;
  const surfaces = joinSurfacePainter(core.request);
  const leave = () => {
    surfaces.leave();
    if (stage.context) surfaces.forget(stage.context);
  };
  if (still) {
    return {
      under: [],
      over: [],
      get painter() {
        return surfaces.current;
      },
      update: () => {},
      destroy: leave,
    };
  }

  const orbit = createOrbit(core, stage, layer);
  const pad = element("button", { type: "button", class: "orbit", "data-orbit": "1" });
  pad.addEventListener("keydown", (event) => {
    const arrow = arrowOf(event);
    const zoom = event.key === "+" || event.key === "=" ? 1 / ZOOM : event.key === "-" ? ZOOM : 1;
    if (event.key === "Escape") orbit.leave();
    if ((!arrow && zoom === 1) || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    const step = STEP * factorOf(event);
    // The figure turns as the arrow points: the camera goes the other way round.
    orbit.turn(-(arrow?.[0] ?? 0) * step, -(arrow?.[1] ?? 0) * step, zoom, true, event.timeStamp);
  });

  let free: Camera | null = null;
  const camera = () => store.state.camera as Camera;
  const own = () => core.own().camera as Camera;
  const go = (next: Camera) => mover.go({ camera: next }, { source: "user", glide: true });
  const button = (name: FlatView | "free", run: () => void) => {
    const made = element("button", { type: "button", "data-view": name }, WORDS[name][lang]);
    made.addEventListener("click", run);
    return made;
  };
  const buttons = {
    free: button("free", () => go(free ?? (flatView(own()) ? [30, 25, own()[2]] : own()))),
    top: button("top", () => go([...FLAT.top, camera()[2]])),
    front: button("front", () => go([...FLAT.front, camera()[2]])),
    side: button("side", () => go([...FLAT.side, camera()[2]])),
  };
  const views = element(
    "div",
    { class: "views", role: "group", "aria-label": WORDS.views[lang] },
    ...Object.values(buttons),
  );
  return {
    under: [pad],
    over: controls === "none" ? [] : [views],
    get painter() {
      return surfaces.current;
    },
    update() {
      const flat = flatView(camera());
      if (!flat && !mover.moving) free = camera();
      for (const [name, made] of Object.entries(buttons)) {
        made.setAttribute("aria-pressed", String(name === (flat ?? "free")));
      }
      const name = `${WORDS.orbit[lang]}. ${viewpoint(camera())[lang]}`;
      if (pad.getAttribute("aria-label") !== name) pad.setAttribute("aria-label", name);
    },
    destroy() {
      orbit.destroy();
      leave();
    },
  };
}
