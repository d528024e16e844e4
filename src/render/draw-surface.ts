import type { FacetsMark } from "../scene/marks.ts";
import { base, clipOf, type Sheet } from "./sheet.ts";

/** The projected facets of a window's surfaces, in pixels. */
export function drawFacets(mark: FacetsMark, { primitives, transform }: Sheet): void {
  const { space } = transform;
  if (!space) throw new RangeError(`mark "${mark.key}": facets belong to a view into space`);
  const facets = mark.facets.map(({ corners, colour }) => ({
    corners: corners.map((corner) => space.plane.toPixel(corner)),
    colour,
  }));
  const clip = clipOf(
    facets.flatMap(({ corners }) => corners.map((corner) => ["L", corner] as const)),
    transform.box,
  );
  primitives.push({ kind: "facets", ...base(mark, "solid"), facets, patches: mark.patches, space, ...clip });
}
