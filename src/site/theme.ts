import { remember } from "./storage.ts";

/** The settings in the order in which the button goes round. */
const SETTINGS = ["auto", "light", "dark"] as const;
type Setting = (typeof SETTINGS)[number];

const root = document.documentElement;

/** The setting that holds; the line in the page's head has set it before the first paint. */
function current(): Setting {
  const theme = root.dataset.theme;
  return theme === "light" || theme === "dark" ? theme : "auto";
}

/** Makes the button of the header go through light, dark and the system's choice, and name where it stands. */
export function themeSwitch(button: HTMLElement): void {
  const name = () => {
    const words = button.dataset[current()] ?? "";
    button.setAttribute("aria-label", words);
    button.title = words;
  };
  button.addEventListener("click", () => {
    const next = SETTINGS[(SETTINGS.indexOf(current()) + 1) % SETTINGS.length]!;
    if (next === "auto") delete root.dataset.theme;
    else root.dataset.theme = next;
    remember("theme", next === "auto" ? null : next);
    name();
  });
  name();
}
