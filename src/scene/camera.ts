/** A point or vector of space. */
export type XYZ = readonly number[];

/**
 * Where space is looked at from: yaw and pitch in degrees, and the distance in units of space.
 *
 * Yaw 0 looks from the front (along +y), 90 from the right side (along −x); pitch 90 looks down. z is up. The picture
 * is orthographic: parallel lines stay parallel, a Bézier arc stays exactly a Bézier arc (a perspective would make it
 * rational, and every vector output an approximation), and a point can be dragged exactly in a plane. Depth is told by
 * light, shadow and occlusion instead. The distance is then only a scale: the window shows, to each side of the
 * target, a quarter of it, as a lens of 28° would.
 */
export type Camera = readonly [yaw: number, pitch: number, distance: number];

/** Half of what a window shows in its shorter direction, as a share of the camera's distance. */
export const REACH = 0.25;

/** The directions of a picture: to the right, upwards, and towards the eye; of length 1, at right angles. */
export interface Axes {
  readonly right: XYZ;
  readonly up: XYZ;
  readonly eye: XYZ;
}

/** Views along an axis of space, in which two coordinates are seen in their true size: yaw and pitch. */
export const FLAT = { top: [0, 90], front: [0, 0], side: [90, 0] } as const;
export type FlatView = keyof typeof FLAT;

/** The flat view that a camera looks along, or null. */
export function flatView([yaw, pitch]: Camera): FlatView | null {
  for (const name of Object.keys(FLAT) as FlatView[]) {
    if (FLAT[name][0] === yaw && FLAT[name][1] === pitch) return name;
  }
  return null;
}

/** The directions of a camera's picture; exact in the flat views, so that dragging there keeps the third coordinate. */
export function axesOf([yaw, pitch]: Camera): Axes {
  const [cy, sy] = circle(yaw);
  const [cp, sp] = circle(pitch);
  return { right: [cy, sy, 0], up: [-sy * sp, cy * sp, cp], eye: [sy * cp, -cy * cp, sp] };
}

/** Cosine and sine of an angle in degrees, exact for right angles. */
function circle(degrees: number): readonly [number, number] {
  const quarter = degrees / 90;
  if (Number.isInteger(quarter)) {
    return ([[1, 0], [0, 1], [-1, 0], [0, -1]] as const)[((quarter % 4) + 4) % 4]!; // biome-ignore format: a table
  }
  const angle = (degrees * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}
