import type { Box } from "../scene/view.ts";
import { inside, lengthInside, overlap } from "./box.ts";
import { freeSide } from "./free-side.ts";
import { boxAround, boxAt, type LabelRequest } from "./label-request.ts";
import { COVERED, type Obstacles } from "./obstacles.ts";

const GAP = 3;
/** Labels keep so far apart from each other. */
const APART = 2;
/** How much further away than necessary a label may stand. */
const AWAY = [0, 5, 11, 19, 29, 42];
const TURNS = 24;

/** Prices of a place, in about "pixels of detour". */
const PRICE = { turn: 26, turnFree: 20, away: 0.9, line: 5, lineLength: 0.4 };

/** The angle from the preferred direction, and how much further away than necessary. */
interface Spot {
  readonly turn: number;
  readonly away: number;
}

const priceOf = ({ turn, away }: Spot, turnPrice: number) =>
  (Math.abs(turn) / Math.PI) * turnPrice + away * PRICE.away;

/** Where a label stands. */
export interface PlacedLabel {
  readonly box: Box;
  /** Whether a line or point runs through it, so that it needs a rim of paper. */
  readonly crossed: boolean;
}

const STEP = (2 * Math.PI) / TURNS;
/** So many directions are tried on both sides of the best one. */
const FINE = 3;

/** All spots that are tried, cheapest first, so that the search can stop early. */
function spots(turnPrice: number): Spot[] {
  const all: Spot[] = [];
  for (let k = 0; k < TURNS; k++) {
    // 0, +1, −1, +2, −2, … steps away from the preferred direction.
    const turn = STEP * (k % 2 === 1 ? (k + 1) / 2 : -k / 2);
    for (const away of AWAY) all.push({ turn, away });
  }
  return all.sort((a, b) => priceOf(a, turnPrice) - priceOf(b, turnPrice));
}

const DIRECTED = spots(PRICE.turn);
const FREE = spots(PRICE.turnFree);

/**
 * Finds a place for each label: beside its point, inside the bounds, never on a handle or on another label,
 * off the lines where possible, in the preferred direction where possible. The answer is null for a label
 * that has no such place; it is better left out than set over another one.
 *
 * Pure: the same requests and obstacles give the same places.
 */
export function placeLabels(
  requests: readonly LabelRequest[],
  obstacles: Obstacles,
  bounds: Box,
): (PlacedLabel | null)[] {
  const result: (PlacedLabel | null)[] = requests.map((request) => {
    if (!request.fixed) return null;
    const box = boxAround(request.at[0]!, request.at[1]!, request);
    return { box, crossed: isCrossed(box, nearby(request, obstacles)) };
  });
  const order = requests
    .map((request, i) => ({ request, i }))
    .filter(({ request }) => !request.fixed)
    .sort((a, b) => a.request.rank - b.request.rank || a.i - b.i);
  const taken = result.flatMap((placed) => (placed ? [placed.box] : []));
  for (const { request, i } of order) {
    const placed = best(request, obstacles, taken, bounds);
    result[i] = placed;
    if (placed) taken.push(placed.box);
  }
  return result;
}

function best(
  request: LabelRequest,
  obstacles: Obstacles,
  taken: readonly Box[],
  bounds: Box,
): PlacedLabel | null {
  const [tx, ty] = request.toward ?? [0, 0];
  const directed = Math.hypot(tx!, ty!) > 1e-9;
  const near = nearby(request, obstacles);
  const start = directed ? Math.atan2(ty!, tx!) : freeSide(request, near);
  const turnPrice = directed ? PRICE.turn : PRICE.turnFree;
  let found: (Spot & { readonly box: Box }) | null = null;
  let lowest = Number.POSITIVE_INFINITY;
  const look = (spot: Spot): void => {
    const price = priceOf(spot, turnPrice);
    if (price >= lowest) return;
    const box = boxAt(request, start + spot.turn, request.clear + GAP + spot.away);
    if (!inside(box, bounds) || taken.some((other) => overlap(box, other, APART))) return;
    const covered = disturbance(box, near, lowest - price);
    if (price + covered >= lowest) return;
    lowest = price + covered;
    found = { box, ...spot };
  };
  for (const spot of directed ? DIRECTED : FREE) {
    if (priceOf(spot, turnPrice) >= lowest) break;
    look(spot);
  }
  const coarse = found as (Spot & { readonly box: Box }) | null;
  if (!coarse) return null;
  // Between the directions tried, so that a label slides with its surroundings and does not hop.
  for (let k = -FINE; k <= FINE; k++) {
    if (k !== 0) look({ turn: coarse.turn + (k * STEP) / (FINE + 1), away: coarse.away });
  }
  const { box } = found ?? coarse;
  return { box, crossed: isCrossed(box, near) };
}

/** The obstacles within the label's reach. */
function nearby({ at, width, height, clear }: LabelRequest, { circles, lines }: Obstacles): Obstacles {
  const [x, y] = [at[0]!, at[1]!];
  const reach = clear + GAP + AWAY.at(-1)! + Math.hypot(width, height) + 2;
  const near: number[] = [];
  for (let i = 0; i < lines.length; i += 5) {
    const [x0, y0, x1, y1] = [lines[i]!, lines[i + 1]!, lines[i + 2]!, lines[i + 3]!];
    if (Math.min(x0, x1) > x + reach || Math.max(x0, x1) < x - reach) continue;
    if (Math.min(y0, y1) > y + reach || Math.max(y0, y1) < y - reach) continue;
    near.push(x0, y0, x1, y1, lines[i + 4]!);
  }
  return {
    circles: circles.filter((c) => Math.abs(c.x - x) < reach + c.r && Math.abs(c.y - y) < reach + c.r),
    lines: near,
  };
}

/** Lines count as soon as they come so near. */
const AIR = 2.5;

/** What a place costs by what it covers; infinite on a handle. Stops once it is more than `enough`. */
function disturbance(box: Box, { circles, lines }: Obstacles, enough: number): number {
  let price = 0;
  for (const { x, y, r, price: cost } of circles) {
    const dx = Math.max(box.left - x, 0, x - box.left - box.width);
    const dy = Math.max(box.top - y, 0, y - box.top - box.height);
    if (dx * dx + dy * dy >= (r + 1) * (r + 1)) continue;
    price += cost;
  }
  const wide: Box = {
    left: box.left - AIR,
    top: box.top - AIR,
    width: box.width + 2 * AIR,
    height: box.height + 2 * AIR,
  };
  for (let i = 0; i < lines.length && price < enough; i += 5) {
    const length = lengthInside(wide, lines[i]!, lines[i + 1]!, lines[i + 2]!, lines[i + 3]!);
    if (length > 0) price += (PRICE.line + length * PRICE.lineLength) * lines[i + 4]!;
  }
  return price;
}

/** Whether a line or a point runs through a box. */
function isCrossed(box: Box, { circles, lines }: Obstacles): boolean {
  return disturbance(box, { circles: circles.filter(({ price }) => price > COVERED.disc), lines }, 1) > 0;
}
