import type { Words } from "../words/words.ts";
import { type Axes, axesOf, type Camera, REACH, type XYZ } from "./camera.ts";
import type { Mark } from "./marks.ts";
import { type ProjectOptions, project } from "./project.ts";
import { type Box, fitView, type View, type ViewTransform } from "./view.ts";

/** What makes a view a window into space. */
export interface SpaceWindow {
  /** The point in the middle of the window. */
  readonly target: XYZ;
  readonly camera: Camera;
  /** The window brings its projection along, so that pages without space need not load it. */
  readonly fit: (view: SpaceView, box: Box) => SpaceViewTransform;
  readonly project: (marks: readonly Mark[], space: SpaceTransform, options: ProjectOptions) => Mark[];
}

export type SpaceView = View & { readonly space: SpaceWindow };

/** How a window into space maps it to the drawing. */
export interface SpaceTransform {
  readonly axes: Axes;
  readonly target: XYZ;
  /** The picture as a plane, with the target at (0, 0): where projected marks are drawn. */
  readonly plane: ViewTransform;
  /** Across and up in the plane of the picture, and towards the eye; in units of space, from the target. */
  project(point: XYZ): readonly [number, number, number];
  /** The point of space at a pixel, in the plane through a given point parallel to the picture. */
  lift(pixel: readonly number[], through: XYZ): XYZ;
}

export type SpaceViewTransform = ViewTransform & { readonly space: SpaceTransform };

/** A view that is a window into space: what it shows is within `radius` of the target, from wherever one looks. */
export function spaceView(options: {
  readonly label: Words;
  readonly target?: XYZ;
  readonly radius: number;
  /** Where it is looked at from at first. */
  readonly yaw?: number;
  readonly pitch?: number;
  readonly height: number;
  readonly narrowHeight?: number;
  readonly beside?: number;
}): SpaceView {
  const { label, radius, target = [0, 0, 0], yaw = 30, pitch = 25, height } = options;
  return {
    label,
    x: [-radius, radius],
    y: [-radius, radius],
    height,
    ...(options.narrowHeight === undefined ? {} : { narrowHeight: options.narrowHeight }),
    ...(options.beside === undefined ? {} : { beside: options.beside }),
    space: { target, camera: [yaw, pitch, radius / REACH], fit: fitSpace, project },
  };
}

/** Fits a window into space into its box; `toPixel` then takes points of space. */
export function fitSpace(view: SpaceView, box: Box): SpaceViewTransform {
  const { target, camera } = view.space;
  const reach = camera[2] * REACH;
  const plane = fitView({ ...view, x: [-reach, reach], y: [-reach, reach] }, box);
  const axes = axesOf(camera);
  const { right, up, eye } = axes;
  const toPicture = (p: XYZ): readonly [number, number, number] => {
    const [x, y, z] = [p[0]! - target[0]!, p[1]! - target[1]!, p[2]! - target[2]!];
    return [
      x * right[0]! + y * right[1]!,
      x * up[0]! + y * up[1]! + z * up[2]!,
      x * eye[0]! + y * eye[1]! + z * eye[2]!,
    ];
  };
  const lift = (pixel: readonly number[], through: XYZ): XYZ => {
    const [across, height] = plane.toWorld(pixel);
    const [fromAcross, fromHeight] = toPicture(through);
    const [dx, dy] = [across - fromAcross, height - fromHeight];
    // A coordinate that the picture does not show stays the very number it was.
    return through.map((x, k) => (right[k] || up[k] ? x + dx * right[k]! + dy * up[k]! : x));
  };
  return {
    ...plane,
    toPixel: (p) => plane.toPixel(toPicture(p)),
    space: { axes, target, plane, project: toPicture, lift },
  };
}
