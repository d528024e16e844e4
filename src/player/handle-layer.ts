import type { BoundHandle } from "../demo/handles.ts";
import type { ViewTransform } from "../scene/view.ts";
import { formatPoint } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";
import { labelText } from "./label-html.ts";
import { WORDS } from "./words.ts";

/** More handles than this share one tab stop; the arrow keys with Tab held back would trap nobody. */
const MAX_TAB_STOPS = 12;

export interface HandleLayer {
  readonly root: HTMLElement;
  /** Puts a focusable element over each handle of the figure; elements are kept as long as the handle is. */
  update(
    handles: readonly BoundHandle[],
    views: Readonly<Record<string, ViewTransform>>,
    scale: number,
  ): void;
  elementOf(id: string): HTMLElement | undefined;
  /** The handle nearest to a point of the stage (CSS pixels), within reach of a finger. */
  nearest(x: number, y: number): string | null;
  select(id: string | null): void;
  readonly selected: string | null;
}

/** Half the width of a finger's target, in CSS pixels. */
const REACH = 22;

export function createHandleLayer(lang: Lang): HandleLayer {
  const root = element("div", { class: "handles" });
  const buttons = new Map<string, HTMLButtonElement>();
  const places = new Map<string, readonly [x: number, y: number, depth: number]>();
  let selected: string | null = null;
  let rover: string | null = null;

  const create = (handle: BoundHandle) => {
    const button = element("button", {
      type: "button",
      class: "handle",
      "data-handle": handle.id,
      "aria-roledescription": WORDS.movable[lang],
    });
    button.addEventListener("focus", () => {
      rover = handle.id;
      tabStops();
    });
    buttons.set(handle.id, button);
    root.append(button);
    return button;
  };
  const tabStops = () => {
    const roving = buttons.size > MAX_TAB_STOPS;
    if (!rover || !buttons.has(rover)) rover = buttons.keys().next().value ?? null;
    for (const [id, button] of buttons) button.tabIndex = !roving || id === rover ? 0 : -1;
  };
  return {
    root,
    get selected() {
      return selected;
    },
    elementOf: (id) => buttons.get(id),
    update(handles, views, scale) {
      const gone = new Set(buttons.keys());
      for (const handle of handles) {
        const view = views[handle.view];
        if (!view) continue;
        gone.delete(handle.id);
        const button = buttons.get(handle.id) ?? create(handle);
        const [x, y] = view.toPixel(handle.at);
        const at = [x * scale, y * scale, view.space?.project(handle.at)[2] ?? 0] as const;
        places.set(handle.id, at);
        button.style.transform = `translate(${at[0].toFixed(2)}px, ${at[1].toFixed(2)}px)`;
        const name = `${labelText(handle.label, lang)} ${formatPoint(handle.at, lang)}`;
        if (button.getAttribute("aria-label") !== name) button.setAttribute("aria-label", name);
        const index = handle.index === undefined ? "" : String(handle.index % 10);
        if (button.dataset.index !== index) button.dataset.index = index;
      }
      for (const id of gone) {
        buttons.get(id)!.remove();
        buttons.delete(id);
        places.delete(id);
        if (selected === id) selected = null;
      }
      tabStops();
    },
    nearest(x, y) {
      let best: string | null = null;
      let distance = REACH;
      let height = -Infinity;
      for (const [id, [hx, hy, depth]] of places) {
        const d = Math.max(Math.abs(hx - x), Math.abs(hy - y)) < REACH ? Math.hypot(hx - x, hy - y) : REACH;
        // Of handles in one place the one on top wins: the nearest in space, else the one drawn last.
        const same = Math.abs(d - distance) < 1;
        if (d < REACH && (same ? depth >= height : d < distance)) {
          best = id;
          distance = d;
          height = depth;
        }
      }
      return best;
    },
    select(id) {
      if (selected) buttons.get(selected)?.classList.remove("is-selected");
      selected = id;
      if (id) buttons.get(id)?.classList.add("is-selected");
    },
  };
}
