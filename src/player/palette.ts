import { forcedPalette, type Palette, palettes } from "../render/theme.ts";
import { type FrameOptions, isDark } from "./frame.ts";

/** The colours a canvas is to be painted with now: canvas pixels are not adjusted by forced colours. */
export function currentPalette(theme: FrameOptions["theme"]): Palette {
  if (matchMedia("(forced-colors: active)").matches) return forced();
  return isDark(theme) ? palettes.dark : palettes.light;
}

let cached: Palette | undefined;
function forced(): Palette {
  cached ??= forcedPalette(systemColour);
  return cached;
}

/** A system colour as the browser resolves it now. */
function systemColour(name: string): string {
  const probe = document.createElement("span");
  probe.style.color = name;
  document.body.append(probe);
  const found = getComputedStyle(probe).color;
  probe.remove();
  return found;
}

/** Calls back when the colours may have changed; gives back how to stop. */
export function watchTheme(changed: () => void): () => void {
  const again = () => {
    cached = undefined;
    changed();
  };
  const queries = ["(prefers-color-scheme: dark)", "(forced-colors: active)"].map((query) =>
    matchMedia(query),
  );
  for (const query of queries) query.addEventListener("change", again);
  const observer = new MutationObserver(again);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
  return () => {
    for (const query of queries) query.removeEventListener("change", again);
    observer.disconnect();
  };
}
