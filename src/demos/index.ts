import type { Demo } from "../demo/index.ts";

/** The registry: a new demo is one file beside this one, and one line here. */
export const demos: Readonly<Record<string, () => Promise<{ default: Demo }>>> = {
  "bernstein-basis": () => import("./bernstein-basis.ts"),
  "bezier-curve": () => import("./bezier-curve.ts"),
  "de-casteljau": () => import("./de-casteljau.ts"),
  glyph: () => import("./glyph.ts"),
};
