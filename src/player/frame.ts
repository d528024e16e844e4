import type { Lang } from "../words/words.ts";

/** How the figure is framed: what a lecturer sets beside the parameters. */
export interface FrameOptions {
  readonly lang: Lang;
  readonly theme: "light" | "dark" | "auto";
  readonly controls: "full" | "compact" | "none";
  readonly autoplay: boolean;
  readonly still: boolean;
  /** The pixel ratio of the canvas, where the host scales the page: 1 … 4. */
  readonly dpr: number | null;
}

/** Reads an option by its name: an attribute, or in an embed the query. */
type Ask = (name: string) => string | null;

export function frameOptions(ask: Ask, element: HTMLElement): FrameOptions {
  const theme = ask("theme");
  const controls = ask("controls");
  const dpr = Number(ask("dpr"));
  return {
    lang: langOf(ask("lang"), element),
    theme: theme === "light" || theme === "dark" ? theme : "auto",
    controls: controls === "compact" || controls === "none" ? controls : "full",
    autoplay: isOn(ask("autoplay")),
    still: isOn(ask("still")),
    dpr: dpr >= 1 && dpr <= 4 ? dpr : null,
  };
}

const isOn = (value: string | null) => value === "1" || value === "";

/** The language asked for, else that of the page around, else the browser's, else German. */
function langOf(asked: string | null, element: HTMLElement): Lang {
  const around = asked ?? element.closest<HTMLElement>("[lang]")?.lang;
  const candidates = around ? [around] : navigator.languages;
  for (const candidate of candidates) {
    const short = candidate.slice(0, 2).toLowerCase();
    if (short === "de" || short === "en") return short;
  }
  return "de";
}

/** Whether the figure is to be dark: as asked, else as the page says, else as the system says. */
export function isDark(theme: FrameOptions["theme"]): boolean {
  const said = theme === "auto" ? document.documentElement.dataset.theme : theme;
  if (said === "light" || said === "dark") return said === "dark";
  return matchMedia("(prefers-color-scheme: dark)").matches;
}

export const reducedMotion = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
