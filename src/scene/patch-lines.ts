import { type Point, patchIsoCurve } from "../math/index.ts";
import { bezierSteps } from "./bezier-steps.ts";
import { path, polyline } from "./draw.ts";
import type { Mark, Role } from "./marks.ts";

type Net = readonly (readonly Point[])[];

/** The lines of a control net, rows and columns, tied to the names `row.i` and `column.j`. */
export function netLines(net: Net, role: Role = "control-polygon"): Mark[] {
  return [
    ...net.map((row, i) => polyline(`row-${i}`, role, row, { name: `row.${i}` })),
    ...net[0]!.map((_, j) =>
      polyline(
        `column-${j}`,
        role,
        net.map((row) => row[j]!),
        { name: `column.${j}` },
      ),
    ),
  ];
}

/** Iso-parametric lines of a Bézier patch at the given parameters, both ways; exact arcs. */
export function patchIsoLines(net: Net, at: readonly number[], role: Role, prefix = "iso"): Mark[] {
  return at.flatMap((value) =>
    (["u", "v"] as const).map((fixed) =>
      path(`${prefix}-${fixed}-${value}`, role, bezierSteps(patchIsoCurve(net, fixed, value))),
    ),
  );
}

/** The four boundary curves of a Bézier patch. */
export function patchEdges(net: Net, role: Role, prefix = "edge"): Mark[] {
  return patchIsoLines(net, [0, 1], role, prefix);
}
