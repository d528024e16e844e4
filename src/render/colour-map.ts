/** The level of a cell that has no value; it is not painted. */
export const NO_VALUE = 255;

/** How many levels a colour map has: 0 … 254. */
export const LEVELS = 255;

type Triple = readonly [number, number, number];

// Both maps stand as filled areas on light and on dark paper, go through lightness evenly, and need only
// blue against yellow or orange, which all three types of colour blindness keep apart.
const STOPS: Readonly<Record<"sequential" | "diverging", readonly Triple[]>> = {
  sequential: [
    [24, 32, 84],
    [32, 74, 130],
    [58, 124, 144],
    [128, 170, 132],
    [206, 208, 116],
    [252, 238, 160],
  ],
  diverging: [
    [10, 66, 130],
    [84, 138, 192],
    [236, 236, 232],
    [214, 142, 76],
    [146, 66, 8],
  ],
};

const tables = { sequential: table(STOPS.sequential), diverging: table(STOPS.diverging) };

function table(stops: readonly Triple[]): readonly Triple[] {
  return Array.from({ length: LEVELS }, (_, level) => {
    const at = (level / (LEVELS - 1)) * (stops.length - 1);
    const i = Math.min(Math.floor(at), stops.length - 2);
    return [0, 1, 2].map((k) =>
      Math.round(stops[i]![k]! + (stops[i + 1]![k]! - stops[i]![k]!) * (at - i)),
    ) as unknown as Triple;
  });
}

/** Red, green and blue, 0 … 255, of a level 0 … 254. */
export function mapColour(colours: "sequential" | "diverging", level: number): Triple {
  return tables[colours][Math.min(level, LEVELS - 1)]!;
}

/**
 * The level of a value: the ends of the range are the ends of the map, values beyond take the nearer end,
 * what is not finite has none. An empty range puts every value in the middle.
 */
export function levelOf(value: number, [low, high]: readonly [number, number]): number {
  if (!Number.isFinite(value)) return NO_VALUE;
  const share = high > low ? (value - low) / (high - low) : 0.5;
  return Math.round(Math.min(1, Math.max(0, share)) * (LEVELS - 1));
}
