import { bernstein, bernsteinAll } from "../math/index.ts";
import { bernsteinBand, bernsteinGraph } from "./bernstein-graph.ts";
import { label, path, polyline, region } from "./draw.ts";
import { symbol } from "./label.ts";
import type { Mark, PathStep } from "./marks.ts";

/** Up to this degree every polynomial carries its name. */
export const LETTERED = 6;

/** The coefficients that sum the polynomials 0 … k: 1 as often, then 0. */
const upTo = (n: number, k: number) => Array.from({ length: n + 1 }, (_, j) => (j <= k ? 1 : 0));
const unit = (n: number, k: number) => Array.from({ length: n + 1 }, (_, j) => (j === k ? 1 : 0));

/** The graphs of all Bernstein polynomials of degree n. They do not depend on t: each degree is drawn once. */
export const bernsteinGraphs = once((n) => unit(n, 0).map((_, k) => bernsteinGraph(unit(n, k))));
/** The bands between the sums B_0 + … + B_k. */
const bands = once((n) => unit(n, 0).map((_, k) => bernsteinBand(upTo(n, k - 1), upTo(n, k))));

function once(draw: (n: number) => PathStep[][]): (n: number) => PathStep[][] {
  const drawn = new Map<number, PathStep[][]>();
  return (n) => {
    const found = drawn.get(n) ?? draw(n);
    drawn.set(n, found);
    return found;
  };
}

/** The name of polynomial k at its highest point, away from the window's edges. */
export function peakLabel(n: number, k: number): Mark {
  const t = inside(k / n);
  return label(`name-${k}`, "curve", [t, bernstein(n, k, t)], symbol("B", k, n), {
    index: k,
    name: `weights.${k}`,
    toward: [0, 1],
  });
}

/** Half the width of the stacked bar at t, and the room that names keep from it and from the edges. */
const HALF = 0.022;
const ROOM = 0.07;
const inside = (t: number) => Math.min(Math.max(t, ROOM), 1 - ROOM);

/** The bands between the sums B_0 + … + B_k, with a bar at t: its pieces are the weights. */
export function bernsteinStack(
  n: number,
  t: number,
  weights: readonly number[],
  shown: (k: number) => boolean,
): Mark[] {
  const [left, right] = [Math.max(0, t - HALF), Math.min(1, t + HALF)];
  let sum = 0;
  const pieces = weights.map((weight, k) => {
    const low = sum;
    sum += weight;
    const corners = [
      [left, low],
      [right, low],
      [right, sum],
      [left, sum],
    ];
    return region(`piece-${k}`, "weight", corners, { index: k, name: `weights.${k}` });
  });
  return [
    ...bands(n).map((steps, k) =>
      path(`band-${k}`, shown(k) ? "handle" : "hull", steps, { paint: "fill", index: k }),
    ),
    ...pieces,
    polyline("one", "reference", [
      [0, 1],
      [1, 1],
    ]),
    ...(n <= LETTERED ? weights.flatMap((_, k) => bandLabel(n, k, t)) : []),
  ];
}

/** The name of band k where the band is highest, beside the bar. */
function bandLabel(n: number, k: number, t: number): Mark[] {
  const top = inside(k / n);
  const at = Math.abs(top - t) < HALF + ROOM ? t + (t > 0.5 ? -1 : 1) * (HALF + ROOM) : top;
  const below = bernsteinAll(n, at)
    .slice(0, k)
    .reduce((sum, w) => sum + w, 0);
  const height = bernstein(n, k, at);
  if (height < 0.1) return [];
  return [
    label(`band-name-${k}`, "curve", [at, below + height / 2], symbol("B", k, n), {
      index: k,
      name: `weights.${k}`,
      place: "centre",
    }),
  ];
}
