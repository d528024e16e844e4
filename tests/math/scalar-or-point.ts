import type { Point } from "../../src/math/index.ts";

/*
 * The reference data give values as numbers or as points; the module takes points. Numbers become points of dimension 1
 * on the way in and numbers again on the way out.
 */
export type Value = number | Point;

export const toPoint = (value: Value): Point => (typeof value === "number" ? [value] : value);

/** Undoes `toPoint` if `sample` was a number. */
export const toValue = (point: Point, sample: Value): Value =>
  typeof sample === "number" ? point[0]! : point;
