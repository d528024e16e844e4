import type { Words } from "../words/words.ts";

/** What the player says of itself. */
export const WORDS = {
  play: { de: "Abspielen", en: "Play" },
  pause: { de: "Anhalten", en: "Pause" },
  undo: { de: "Rückgängig", en: "Undo" },
  redo: { de: "Wiederholen", en: "Redo" },
  reset: { de: "Zurücksetzen", en: "Reset" },
  fullscreen: { de: "Vollbild", en: "Full screen" },
  values: { de: "Werte und Tastatur", en: "Values and keyboard" },
  readout: { de: "Werte", en: "Values" },
  movable: { de: "verschiebbarer Punkt", en: "movable point" },
  nudge: { de: "Ausgewählten Punkt verschieben", en: "Move the selected point" },
  left: { de: "nach links", en: "left" },
  right: { de: "nach rechts", en: "right" },
  up: { de: "nach oben", en: "up" },
  down: { de: "nach unten", en: "down" },
  orbit: { de: "Ansicht drehen", en: "Turn the view" },
  views: { de: "Ansicht", en: "View" },
  free: { de: "frei", en: "free" },
  top: { de: "oben", en: "top" },
  front: { de: "vorn", en: "front" },
  side: { de: "Seite", en: "side" },
  pencil: { de: "Zeichenstift", en: "Pencil" },
  pencilAt: { de: "Zeichenstift, Eingabetaste setzt einen Punkt", en: "Pencil, Enter sets a point" },
  keyboard: { de: "Tastatur", en: "Keyboard" },
  noFullscreen: {
    de: "Der Browser erlaubt hier kein Vollbild.",
    en: "The browser does not allow full screen here.",
  },
  noDemo: {
    de: "Diese Figur gibt es nicht:",
    en: "There is no such figure:",
  },
  notLoaded: {
    de: "Die Figur konnte nicht geladen werden. Das Standbild bleibt; ein neuer Versuch lädt die Seite neu.",
    en: "The figure could not be loaded. The still picture stays; trying again reloads the page.",
  },
  broken: {
    de: "In dieser Figur ist ein Fehler aufgetreten. Die übrige Seite arbeitet weiter.",
    en: "Something went wrong in this figure. The rest of the page keeps working.",
  },
  retry: { de: "Neu laden", en: "Reload" },
  unreadable: { de: "Nicht übernommen", en: "Not taken over" },
} as const satisfies Record<string, Words>;
