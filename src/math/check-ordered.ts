import { checkNumber } from "./check.ts";

/** Demands two finite numbers, the second greater than the first: the ends of an interval given as two arguments. */
export function checkOrdered(lowName: string, low: number, highName: string, high: number): void {
  checkNumber(lowName, low);
  checkNumber(highName, high);
  if (!(high > low)) {
    throw new RangeError(`${highName}: expected a number greater than ${lowName} = ${low}, got ${high}`);
  }
}
