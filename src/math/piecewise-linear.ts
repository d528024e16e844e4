import { checkAscending, checkNumber, checkNumbers, checkSameLength } from "./check.ts";
import { findInterval } from "./find-interval.ts";
import { linearPosition, linearValue } from "./linear-interpolation.ts";

/**
 * The value at x of the polyline through the data points (positions[i], values[i]).
 *
 * `positions` strictly ascending, at least one. Before the first and after the last position the end value is held.
 *
 * @throws RangeError if the lists do not fit, the positions do not ascend or a number is not finite.
 */
export function piecewiseLinearValue(
  positions: readonly number[],
  values: readonly number[],
  x: number,
): number {
  checkData(positions, values);
  checkNumber("x", x);
  const last = positions.length - 1;
  if (x <= positions[0]!) return values[0]!;
  if (x >= positions[last]!) return values[last]!;
  const i = findInterval(positions, x);
  return linearValue(positions[i]!, values[i]!, positions[i + 1]!, values[i + 1]!, x)!.value;
}

/** The places where a polyline takes a value. */
export type Crossings = {
  /** Single positions, ascending, each once. */
  readonly positions: readonly number[];
  /** Intervals on which the polyline is constant at the value, ascending, joined where they touch. */
  readonly plateaus: readonly (readonly [number, number])[];
};

/**
 * All positions at which the polyline through the data points takes the target value, none of them twice.
 *
 * The position from a value need not be unique and may not exist. On a constant piece at the target every position has
 * the value: such pieces are listed as plateaus (their ends are not among the single positions).
 *
 * @throws RangeError as `piecewiseLinearValue`.
 */
export function piecewiseLinearPositions(
  positions: readonly number[],
  values: readonly number[],
  target: number,
): Crossings {
  checkData(positions, values);
  checkNumber("target", target);
  const single: number[] = [];
  const plateaus: [number, number][] = [];
  for (let i = 0; i < positions.length; i++) {
    const plateau = plateaus.at(-1);
    if (values[i] === target && values[i + 1] === target) {
      if (plateau && plateau[1] === positions[i]) plateau[1] = positions[i + 1]!;
      else plateaus.push([positions[i]!, positions[i + 1]!]);
    } else if (values[i] === target) {
      if (!plateau || plateau[1] !== positions[i]) single.push(positions[i]!);
    } else if (Math.sign(values[i]! - target) * Math.sign((values[i + 1] ?? target) - target) < 0) {
      const between = linearPosition(
        [positions[i]!],
        values[i]!,
        [positions[i + 1]!],
        values[i + 1]!,
        target,
      );
      single.push(between!.position[0]!);
    }
  }
  return { positions: single, plateaus };
}

function checkData(positions: readonly number[], values: readonly number[]): void {
  checkAscending("positions", positions);
  checkNumbers("values", values);
  checkSameLength("values", values, "positions", positions);
}
