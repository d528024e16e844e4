import { label, point, polyline, region } from "./draw.ts";
import { type Label, symbol } from "./label.ts";
import type { Mark } from "./marks.ts";
import type { View } from "./view.ts";

/** The window of the parameter rectangle, drawn as the square [0, 1]², beside the surface it is mapped to. */
export function domainView(options: Partial<View> = {}): View {
  return {
    label: { de: "Parameterbereich", en: "Parameter domain" },
    x: [-0.32, 1.12],
    y: [-0.26, 1.14],
    height: 0.3,
    narrowHeight: 0.52,
    beside: 0.27,
    ...options,
  };
}

/** The numbers at the ends of both axes of the rectangle. */
export interface DomainEnds {
  readonly u: readonly [Label, Label];
  readonly v: readonly [Label, Label];
}

const number = (base: string): Label => ({ base, style: "text" });
const UNIT: DomainEnds = { u: [number("0"), number("1")], v: [number("0"), number("1")] };

/**
 * The parameter rectangle with the lines u = const and v = const through a place, both given as shares 0 … 1; the place
 * itself is a handle, or else a point.
 */
export function domainMarks(
  [u, v]: readonly [number, number],
  { ends = UNIT, handle = true }: { readonly ends?: DomainEnds; readonly handle?: boolean } = {},
): Mark[] {
  const corners = [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ];
  const text = (key: string, x: number, y: number, base: Label) =>
    label(key, "axis", [x, y], base, { place: "centre" });
  return [
    region("domain", "curve", corners, { name: "domain" }),
    polyline("domain-edge", "axis", [...corners, corners[0]!]),
    // Along the first line v is constant: on the surface it becomes the curve in u.
    polyline("domain-u-line", "curve", [[0, v], [1, v]], { name: "u-line" }), // biome-ignore format: two points
    polyline("domain-v-line", "curve", [[u, 0], [u, 1]], { name: "v-line" }), // biome-ignore format: two points
    text("u-from", 0, -0.12, ends.u[0]),
    text("u-to", 1, -0.12, ends.u[1]),
    text("u-name", 0.5, -0.12, symbol("u")),
    text("v-from", -0.17, 0, ends.v[0]),
    text("v-to", -0.17, 1, ends.v[1]),
    text("v-name", -0.17, 0.5, symbol("v")),
    ...(handle ? [] : [point("domain-place", "curve", [u, v])]),
  ];
}
