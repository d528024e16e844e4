import type { XY } from "../scene/marks.ts";
import type { Box } from "../scene/view.ts";
import { inside, lengthInside, overlap } from "./box.ts";
import type { Obstacles } from "./obstacles.ts";

/** Lettering that looks for its place. */
export interface LabelRequest {
  readonly at: XY;
  readonly width: number;
  readonly height: number;
  /** Radius that is taken at the point itself. */
  readonly clear: number;
  /** The preferred direction in pixels (y downwards); absent or zero: none. */
  readonly toward?: XY;
  /** Stands exactly on its point and is only kept clear of. */
  readonly fixed: boolean;
  /** Labels of a lower rank choose first. */
  readonly rank: number;
}

const GAP = 3;
/** Labels keep so far apart from each other. */
const APART = 2;
/** How much further away than necessary a label may stand. */
const AWAY = [0, 5, 11, 19, 29, 42];
const TURNS = 16;

/** Prices of a place, in about "pixels of detour". */
const PRICE = { turn: 26, turnFree: 7, away: 0.9, line: 7, lineLength: 0.45, point: 40 };

interface Place {
  readonly turn: number;
  readonly away: number;
  readonly price: number;
}

/** Where a label stands. */
export interface PlacedLabel {
  readonly box: Box;
  /** Whether a line or point runs through it, so that it needs a rim of paper. */
  readonly crossed: boolean;
}

/** All places that are tried, cheapest first, so that the search can stop early. */
function places(turnPrice: number): Place[] {
  const all: Place[] = [];
  for (let k = 0; k < TURNS; k++) {
    // 0, +1, −1, +2, −2, … steps away from the preferred direction.
    const steps = k % 2 === 1 ? (k + 1) / 2 : -k / 2;
    const turn = (steps * 2 * Math.PI) / TURNS;
    for (const away of AWAY) {
      all.push({ turn, away, price: (Math.abs(turn) / Math.PI) * turnPrice + away * PRICE.away });
    }
  }
  return all.sort((a, b) => a.price - b.price);
}

const DIRECTED = places(PRICE.turn);
const FREE = places(PRICE.turnFree);

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
    return { box, crossed: disturbance(box, nearby(request, obstacles), 1) > 0 };
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
  // Without a wish, to the upper right: where a reader looks for a name.
  const start = directed ? Math.atan2(ty!, tx!) : -Math.PI / 4;
  const near = nearby(request, obstacles);
  let found: PlacedLabel | null = null;
  let lowest = Number.POSITIVE_INFINITY;
  for (const place of directed ? DIRECTED : FREE) {
    if (place.price >= lowest) break;
    const box = boxAt(request, start + place.turn, request.clear + GAP + place.away);
    if (!inside(box, bounds) || taken.some((other) => overlap(box, other, APART))) continue;
    const covered = disturbance(box, near, lowest - place.price);
    if (place.price + covered < lowest) {
      lowest = place.price + covered;
      found = { box, crossed: covered > 0 };
    }
  }
  return found;
}

/** The box whose nearest point is `distance` from the label's point, in the given direction. */
function boxAt(request: LabelRequest, angle: number, distance: number): Box {
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
  const [ax, ay] = [Math.abs(dx), Math.abs(dy)];
  const [a, b] = [request.width / 2, request.height / 2];
  const beside = (distance + a) / ax;
  const above = (distance + b) / ay;
  let reach: number;
  if (beside * ay <= b) reach = beside;
  else if (above * ax <= a) reach = above;
  else {
    // A corner is nearest: |(reach·ax − a, reach·ay − b)| = distance.
    const m = ax * a + ay * b;
    reach = m + Math.sqrt(Math.max(0, m * m - (a * a + b * b - distance * distance)));
  }
  return boxAround(request.at[0]! + dx * reach, request.at[1]! + dy * reach, request);
}

function boxAround(x: number, y: number, { width, height }: LabelRequest): Box {
  return { left: x - width / 2, top: y - height / 2, width, height };
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
  for (const { x, y, r, hard } of circles) {
    const dx = Math.max(box.left - x, 0, x - box.left - box.width);
    const dy = Math.max(box.top - y, 0, y - box.top - box.height);
    if (dx * dx + dy * dy >= (r + 1) * (r + 1)) continue;
    if (hard) return Number.POSITIVE_INFINITY;
    price += PRICE.point;
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
