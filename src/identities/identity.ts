/** A number, a point, a list of points, …: what stands on one side of an equals sign. */
export type Side = number | readonly Side[];

/** Random numbers for a check; the tests bring them, so that the checks stay pure. */
export interface Draw {
  number(min: number, max: number): number;
  integer(min: number, max: number): number;
  /** Points with coordinates in [−10, 10]. */
  points(count: number, dimension?: number): readonly (readonly number[])[];
}

/** A displayed formula of a lesson, and its proof by the mathematics that the figures run. */
export interface Identity {
  /** The formula as the lesson writes it; the build compares the two, without spaces and ties. */
  readonly formula: string;
  /**
   * Both sides of each equation for one random input: one side as the formula says, the other as `src/math` computes it.
   */
  sides(draw: Draw): readonly (readonly [Side, Side])[];
  /** How far the sides may differ, relative to their size. Default: 1e-9. */
  readonly tolerance?: number;
}

/** The sum of f(i) for i = from … to. */
export function sum(from: number, to: number, f: (i: number) => number): number {
  let total = 0;
  for (let i = from; i <= to; i++) total += f(i);
  return total;
}
