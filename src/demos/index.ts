import type { Demo } from "../demo/index.ts";

/** The registry: a new demo is one file beside this one, and one line here. */
export const demos: Readonly<Record<string, () => Promise<{ default: Demo }>>> = {
  "bernstein-basis": () => import("./bernstein-basis.ts"),
  "bezier-curve": () => import("./bezier-curve.ts"),
  "bezier-patch": () => import("./bezier-patch.ts"),
  "de-casteljau": () => import("./de-casteljau.ts"),
  glyph: () => import("./glyph.ts"),
  "hermite-basis": () => import("./hermite-basis.ts"),
  "hermite-segment": () => import("./hermite-segment.ts"),
  "parametric-surface": () => import("./parametric-surface.ts"),
  "surface-tangents": () => import("./surface-tangents.ts"),
  teapot: () => import("./teapot.ts"),
  "tensor-product": () => import("./tensor-product.ts"),
};
