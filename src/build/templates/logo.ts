import type { Html } from "./types.ts";

/** The weights that hold the lath of the logo. */
export const LOGO_POINTS = [
  [5, 25],
  [19, 10.5],
  [37, 18.5],
  [59, 6],
] as const;

/**
 * The lath through them: the natural cubic spline, each piece as the two inner Bézier points (ends are the
 * weights). That it is one, C² at the weights and straight at its ends, is tested.
 */
export const LOGO_INNER = [
  [9.666666666666668, 18.305293693116877, 14.333333333333332, 11.610587386233759],
  [25, 9.072101931985168, 31, 16.875094324635608],
  [44.333333333333336, 20.485995825445364, 51.666666666666664, 13.242997912722682],
] as const;

/** The spline as path data of an SVG. */
export function logoPath(): string {
  const [start, ...ends] = LOGO_POINTS;
  const arcs = ends.map((end, i) => `C${[...LOGO_INNER[i]!, ...end].map(short).join(" ")}`);
  return `M${start.join(" ")}${arcs.join("")}`;
}

const short = (value: number) => String(Math.round(value * 100) / 100);

/** The logo, decorative: the name stands beside it. */
export function logo(): Html {
  const weights = LOGO_POINTS.map(([x, y]) => `<circle cx="${x}" cy="${y}" r="3.2"/>`).join("");
  return `<svg class="logo" viewBox="0 0 64 31" width="44" height="21" aria-hidden="true" focusable="false"><path d="${logoPath()}"/>${weights}</svg>`;
}
