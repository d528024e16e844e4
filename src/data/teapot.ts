import { coordinates, indices } from "./teapot-numbers.ts";

/*
 * The Utah teapot: the bicubic Bézier patches that Martin Newell drew in 1975 (The utilization of procedure models in
 * digital image synthesis, PhD thesis, University of Utah), flattened by James Blinn to about three quarters of its
 * height, with the four patches of the bottom that others added later; 32 in all. The numbers are those of the table in
 * three.js 0.187, examples/jsm/geometries/TeapotGeometry.js (MIT licence, beside this file), which has them from Eric
 * Haines' Standard Procedural Databases. Nothing is changed but the order of the rows, see `teapot`.
 */

/** A part of the teapot: the patches from one index up to, not including, the next. */
export interface TeapotPart {
  readonly id: "rim" | "body" | "handle" | "spout" | "lid" | "bottom";
  readonly from: number;
  readonly to: number;
}

export const teapotParts: readonly TeapotPart[] = [
  { id: "rim", from: 0, to: 4 },
  { id: "body", from: 4, to: 12 },
  { id: "handle", from: 12, to: 16 },
  { id: "spout", from: 16, to: 20 },
  { id: "lid", from: 20, to: 28 },
  { id: "bottom", from: 28, to: 32 },
];

/**
 * The control nets of the 32 patches, 4 × 4 points each. In the table S_u × S_v points into the pot; here u and v are
 * exchanged, so that all normals point outwards.
 */
export const teapot: readonly (readonly (readonly (readonly number[])[])[])[] = Array.from(
  { length: indices.length / 16 },
  (_, patch) =>
    [0, 1, 2, 3].map((i) =>
      [0, 1, 2, 3].map((j) => {
        const at = 3 * indices[16 * patch + 4 * j + i]!;
        return coordinates.slice(at, at + 3);
      }),
    ),
);
