import type { PathStep, XY } from "../scene/marks.ts";
import { INDEX_COUNT } from "./palette.ts";

/**
 * The shapes that tell the entries of the index palette apart without colour, in its order. None of them is
 * a sign: a plus or a cross in a handle would look like a button.
 */
export const SHAPES = [
  "disc",
  "square",
  "diamond",
  "triangle",
  "star",
  "down",
  "hourglass",
  "half",
  "spark",
  "hexagon",
] as const satisfies readonly string[] & { readonly length: typeof INDEX_COUNT };

export type Shape = (typeof SHAPES)[number];

/** The shape of an index; a disc where there is none. */
export function shapeOf(index: number | undefined): Shape {
  if (index === undefined) return "disc";
  return SHAPES[((Math.trunc(index) % INDEX_COUNT) + INDEX_COUNT) % INDEX_COUNT]!;
}

/** Corners for radius 1, y downwards; of about the same area, so that none looks larger. */
const CORNERS: Readonly<Record<Exclude<Shape, "disc">, readonly XY[]>> = {
  square: [
    [-0.88, -0.88],
    [0.88, -0.88],
    [0.88, 0.88],
    [-0.88, 0.88],
  ],
  diamond: turned(4, 1.26, -90),
  triangle: turned(3, 1.28, -90),
  star: star(5, 1.42, 0.62),
  down: turned(3, 1.28, 90),
  hourglass: [
    [-1.05, -1.1],
    [1.05, -1.1],
    [0.22, 0],
    [1.05, 1.1],
    [-1.05, 1.1],
    [-0.22, 0],
  ],
  half: Array.from({ length: 13 }, (_, i) => polar(1.38, 180 + 15 * i)).map(([x, y]) => [x!, y! + 0.62]),
  spark: star(4, 1.55, 0.58),
  hexagon: turned(6, 1.1, 0),
};

function turned(count: number, radius: number, start: number): XY[] {
  return Array.from({ length: count }, (_, i) => polar(radius, start + (360 * i) / count));
}

function polar(radius: number, degrees: number): XY {
  const angle = (degrees * Math.PI) / 180;
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

function star(points: number, outer: number, inner: number): XY[] {
  return Array.from({ length: 2 * points }, (_, i) =>
    polar(i % 2 === 0 ? outer : inner, -90 + (180 * i) / points),
  );
}

/** The outline of a shape other than the disc. */
export function shapeSteps(shape: Exclude<Shape, "disc">, [x, y]: XY, radius: number): PathStep[] {
  const corners = CORNERS[shape].map(([dx, dy]) => [x! + dx! * radius, y! + dy! * radius]);
  return [...corners.map((corner, i) => [i === 0 ? "M" : "L", corner] as const), ["Z"]];
}
