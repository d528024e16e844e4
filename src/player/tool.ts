import { element, icon } from "./element.ts";

/** Drawings of 24 × 24, stroked; play and pause are filled. */
const ICONS = {
  play: "M7 4.5v15l12-7.5z",
  pause: "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",
  undo: "M8.5 5 4 9.5 8.5 14M4.5 9.5H14a5 5 0 0 1 0 10h-4",
  redo: "M15.5 5 20 9.5 15.5 14M19.5 9.5H10a5 5 0 0 0 0 10h4",
  reset: "M5 5v5h5M5.5 10A7.5 7.5 0 1 1 4.6 14",
  fullscreen: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  values: "M4 7h9M17 7h3M4 17h3M11 17h9M15 4.5v5M9 14.5v5",
  pencil: "M4 20l1-4L16 5l3 3L8 19zM14 7l3 3",
} as const;

export type ToolId = keyof typeof ICONS;

/** A button of the toolbar. */
export interface Tool {
  readonly root: HTMLButtonElement;
  update(look: { name: string; icon?: ToolId; disabled?: boolean; pressed?: boolean }): void;
}

export function createTool(id: ToolId, run: () => void): Tool {
  const drawing = icon(ICONS[id]);
  const root = element("button", { type: "button", class: `tool tool-${id}` }, drawing);
  root.addEventListener("click", run);
  return {
    root,
    update({ name, icon: picture, disabled, pressed }) {
      if (root.title !== name) {
        root.title = name;
        root.setAttribute("aria-label", name);
      }
      if (picture) drawing.firstElementChild!.setAttribute("d", ICONS[picture]);
      // A truly disabled button would lose the focus that has just pressed it.
      if (disabled !== undefined) root.setAttribute("aria-disabled", String(disabled));
      if (pressed !== undefined) root.setAttribute("aria-pressed", String(pressed));
    },
  };
}
