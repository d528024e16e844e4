import type { ViewTransform } from "../scene/view.ts";
import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";
import { arrowOf, factorOf } from "./shortcuts.ts";
import { WORDS } from "./words.ts";

/** The pencil: a line drawn with mouse, pen or finger, or point by point with the keys. */
export interface Pencil {
  /** The view it draws in. */
  readonly view: string;
  /** The focusable cross of the keyboard pencil. */
  readonly cross: HTMLElement;
  readonly on: boolean;
  toggle(on: boolean): void;
  draw(x: number, y: number, phase: "start" | "move" | "end"): void;
  /** Puts the cross where it belongs after the size has changed. */
  update(view: ViewTransform, scale: number): void;
}

/** `put` takes the points drawn so far, in the plane of the view. */
export function createPencil(
  stage: HTMLElement,
  lang: Lang,
  viewId: string,
  points: () => readonly (readonly number[])[],
  put: (points: readonly (readonly number[])[], commit: boolean) => void,
): Pencil {
  const cross = element("button", {
    type: "button",
    class: "pencil-cross",
    "aria-label": WORDS.pencilAt[lang],
  });
  cross.hidden = true;
  let on = false;
  let line: (readonly number[])[] = [];
  let at: readonly [number, number] | null = null;
  let view: ViewTransform | undefined;
  let scale = 1;

  const world = (x: number, y: number) => view!.toWorld([x / scale, y / scale]);
  const showCross = () => {
    if (!view) return;
    at ??= [(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2];
    const [x, y] = view.toPixel(at);
    cross.style.transform = `translate(${x * scale}px, ${y * scale}px)`;
  };
  cross.addEventListener("keydown", (event) => {
    const arrow = arrowOf(event);
    if (arrow && view && at) {
      event.preventDefault();
      const stride = ((view.x[1] - view.x[0]) / 50) * factorOf(event);
      at = [at[0] + arrow[0] * stride, at[1] + arrow[1] * stride];
      showCross();
    }
  });
  cross.addEventListener("click", (event) => {
    // Only Enter and Space come here: a pointer draws on the stage.
    if (event.detail === 0 && at) put([...points(), at], true);
  });
  return {
    view: viewId,
    cross,
    get on() {
      return on;
    },
    toggle(next) {
      on = next;
      cross.hidden = !on;
      stage.classList.toggle("is-drawing", on);
      showCross();
    },
    draw(x, y, phase) {
      if (!view) return;
      const point = world(x, y);
      line = phase === "start" ? [point] : [...line, point];
      put(line, phase === "end");
    },
    update(next, nextScale) {
      view = next;
      scale = nextScale;
      if (on) showCross();
    },
  };
}
