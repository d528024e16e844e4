import type { PathStep, XY } from "../scene/marks.ts";
import { INDEX_COUNT } from "./palette.ts";

/** The shapes that tell the entries of the index palette apart without colour, in its order. */
export const SHAPES = [
  "disc",
  "square",
  "diamond",
  "triangle",
  "plus",
  "down",
  "star",
  "bar",
  "cross",
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
  plus: cross(1.18, 0.4, 0),
  down: turned(3, 1.28, 90),
  star: star(),
  bar: [
    [-1.2, -0.52],
    [1.2, -0.52],
    [1.2, 0.52],
    [-1.2, 0.52],
  ],
  cross: cross(1.24, 0.38, 45),
  hexagon: turned(6, 1.1, 0),
};

function turned(count: number, radius: number, start: number): XY[] {
  return Array.from({ length: count }, (_, i) => polar(radius, start + (360 * i) / count));
}

function polar(radius: number, degrees: number): XY {
  const angle = (degrees * Math.PI) / 180;
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

function star(): XY[] {
  return Array.from({ length: 10 }, (_, i) => polar(i % 2 === 0 ? 1.4 : 0.6, -90 + 36 * i));
}

function cross(reach: number, half: number, turn: number): XY[] {
  return [0, 90, 180, 270].flatMap((quarter) =>
    [
      [reach, -half],
      [reach, half],
      [half, half],
    ].map(([x, y]) => {
      const angle = ((quarter + turn) * Math.PI) / 180;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      return [c * x! - s * y!, s * x! + c * y!];
    }),
  );
}

/** The outline of a shape other than the disc. */
export function shapeSteps(shape: Exclude<Shape, "disc">, [x, y]: XY, radius: number): PathStep[] {
  const corners = CORNERS[shape].map(([dx, dy]) => [x! + dx! * radius, y! + dy! * radius]);
  return [...corners.map((corner, i) => [i === 0 ? "M" : "L", corner] as const), ["Z"]];
}
