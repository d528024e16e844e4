import type { Html } from "./types.ts";

const icon = (name: string, inner: string): Html =>
  `<svg class="icon ${name}" viewBox="0 0 24 24" width="20" height="20" aria-hidden="true" focusable="false">${inner}</svg>`;

/** A list whose entries stand like the sections of a lesson. */
export const CONTENTS_ICON: Html = icon("list", '<path d="M4 6.5h16M8 12h12M8 17.5h12"/>');

/** Half light, half dark; a sun; a moon: which one is seen is decided by the style sheet. */
export const THEME_ICONS: Html = [
  icon("auto", '<circle cx="12" cy="12" r="7.5"/><path class="full" d="M12 4.5a7.5 7.5 0 0 1 0 15z"/>'),
  icon(
    "light",
    '<circle cx="12" cy="12" r="4"/><path d="M12 3v2.5M12 18.5V21M3 12h2.5M18.5 12H21M5.6 5.6l1.8 1.8M16.6 16.6l1.8 1.8M5.6 18.4l1.8-1.8M16.6 7.4l1.8-1.8"/>',
  ),
  icon("dark", '<path d="M19.5 14.2A8 8 0 0 1 9.8 4.5a8 8 0 1 0 9.7 9.7z"/>'),
].join("");
