import type { Words } from "../words/words.ts";

/** What a key does while the focus is in the figure. The help list and the keyboard read the same table. */
export type Command = "undo" | "redo" | "play" | "leave";

export interface Shortcut {
  readonly keys: Words;
  readonly does: Words;
}

/** The list that the reader sees. */
export const SHORTCUTS: readonly Shortcut[] = [
  {
    keys: { de: "Pfeiltasten", en: "Arrow keys" },
    does: { de: "Punkt oder Regler bewegen", en: "move the point or slider" },
  },
  {
    keys: { de: "Umschalt + Pfeil", en: "Shift + arrow" },
    does: { de: "fünffacher Schritt", en: "five times the step" },
  },
  {
    keys: { de: "Alt + Pfeil", en: "Alt + arrow" },
    does: { de: "Viertelschritt", en: "a quarter of the step" },
  },
  {
    keys: { de: "Pos1, Ende", en: "Home, End" },
    does: { de: "Regler an Anfang oder Ende", en: "slider to its start or end" },
  },
  {
    keys: { de: "[ und ], Bild auf und ab", en: "[ and ], Page up and down" },
    does: { de: "im Raum: Punkt in die Tiefe bewegen", en: "in space: move the point in depth" },
  },
  {
    keys: { de: "Pfeile, + und − auf dem Bild", en: "Arrows, + and − on the picture" },
    does: { de: "im Raum: Ansicht drehen, näher, ferner", en: "in space: turn the view, nearer, farther" },
  },
  { keys: { de: "Strg + Z", en: "Ctrl + Z" }, does: { de: "rückgängig", en: "undo" } },
  {
    keys: { de: "Strg + Umschalt + Z", en: "Ctrl + Shift + Z" },
    does: { de: "wiederholen", en: "redo" },
  },
  {
    keys: { de: "Leertaste auf einem Punkt", en: "Space on a point" },
    does: { de: "abspielen oder anhalten", en: "play or pause" },
  },
  {
    keys: { de: "Esc", en: "Esc" },
    does: { de: "Ziehen abbrechen, Figur verlassen", en: "cancel the drag, leave the figure" },
  },
];

/** The command of a key event, or null. */
export function commandOf(event: KeyboardEvent, onHandle: boolean): Command | null {
  const control = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  if (control && key === "z") return event.shiftKey ? "redo" : "undo";
  if (control && key === "y") return "redo";
  if (event.key === "Escape") return "leave";
  if (event.key === " " && onHandle) return "play";
  return null;
}

/** Where an arrow key points to, in the axes of the picture. */
export function arrowOf(event: KeyboardEvent): readonly [number, number] | null {
  if (event.ctrlKey || event.metaKey) return null;
  switch (event.key) {
    case "ArrowLeft":
      return [-1, 0];
    case "ArrowRight":
      return [1, 0];
    case "ArrowUp":
      return [0, 1];
    case "ArrowDown":
      return [0, -1];
    default:
      return null;
  }
}

/** The third direction of space: towards the eye with Page down or ], away with Page up or [; page keys belong to decks. */
export function depthOf(event: KeyboardEvent, embedded: boolean): readonly [0, 0, number] | null {
  if (event.ctrlKey || event.metaKey) return null;
  if (event.key === "[" || (event.key === "PageUp" && !embedded)) return [0, 0, -1];
  if (event.key === "]" || (event.key === "PageDown" && !embedded)) return [0, 0, 1];
  return null;
}

/** Shift makes steps five times as long, Alt a quarter. */
export function factorOf(event: KeyboardEvent): number {
  return event.shiftKey ? 5 : event.altKey ? 0.25 : 1;
}
