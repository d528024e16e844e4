import { boolean, choice, defineDemo, net, points } from "../demo/index.ts";
import {
  bezierPatch,
  patchCurvatureSampler,
  patchIsoCurve,
  patchTessellator,
  surfaceCurvature,
  surfaceNormal,
  toFlatNet,
} from "../math/index.ts";
import { bezierSteps } from "../scene/bezier-steps.ts";
import { label, path, point } from "../scene/draw.ts";
import { symbol } from "../scene/label.ts";
import type { PatchMark } from "../scene/marks.ts";
import { normalMarks } from "../scene/normal-marks.ts";
import { netLines, patchEdges } from "../scene/patch-lines.ts";
import { spaceView } from "../scene/space.ts";
import { axisArrows, ground, patch } from "../scene/surfaces.ts";
import { domainMarks, domainView } from "../scene/uv-domain.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth } from "../words/words.ts";

/** Quads along each side of the patch. */
const STEPS = 24;
const tessellate = patchTessellator(3, 3, STEPS, STEPS);
const sampleCurvature = patchCurvatureSampler(3, 3, STEPS, STEPS);
/** The Gaussian curvatures at the ends of the colour map: −1 blue, 0 white, 1 orange. */
const CURVATURE = 1;

/** A bicubic Bézier patch that can be bent by its sixteen control points. */
export default defineDemo({
  id: "bezier-patch",
  title: { de: "Bikubisches Bézierstück", en: "Bicubic Bézier patch" },
  params: {
    points: net({
      initial: [
        [
          [-1.5, -1.5, 0],
          [-1.5, -0.5, 0.9],
          [-1.5, 0.5, 0.7],
          [-1.5, 1.5, -0.1],
        ],
        [
          [-0.5, -1.5, 0.6],
          [-0.5, -0.5, 2],
          [-0.5, 0.5, 1.5],
          [-0.5, 1.5, 0.5],
        ],
        [
          [0.5, -1.5, 0.7],
          [0.5, -0.5, 1.6],
          [0.5, 0.5, -0.6],
          [0.5, 1.5, 0.3],
        ],
        [
          [1.5, -1.5, -0.2],
          [1.5, -0.5, 0.5],
          [1.5, 0.5, 0.6],
          [1.5, 1.5, 0.9],
        ],
      ],
      label: { de: "Kontrollnetz", en: "Control net" },
      range: [-4, 4],
    }),
    uv: points({
      initial: [[0.6, 0.35]],
      label: { de: "Parameter u und v", en: "Parameters u and v" },
      names: [{ base: "u, v" }],
      axes: ["u", "v"],
      view: "domain",
      x: [0, 1],
      y: [0, 1],
      indexed: false,
    }),
    shading: choice({
      initial: "lit",
      label: { de: "Farbe der Fläche", en: "Colour of the surface" },
      options: [
        { id: "lit", label: { de: "Licht", en: "light" } },
        { id: "normals", label: { de: "Richtung der Normalen", en: "direction of the normals" } },
        { id: "curvature", label: { de: "Gaußsche Krümmung", en: "Gaussian curvature" } },
        { id: "stripes", label: { de: "Spiegelstreifen", en: "reflection stripes" } },
      ],
    }),
    net: boolean({ initial: true, label: { de: "Kontrollnetz zeigen", en: "Show the control net" } }),
    normal: boolean({ initial: false, label: { de: "Normale zeigen", en: "Show the normal" } }),
  },
  views: {
    space: spaceView({
      label: { de: "Fläche und Kontrollnetz", en: "Surface and control net" },
      target: [0, 0, 0.35],
      radius: 2,
      yaw: 28,
      pitch: 26,
      height: 0.6,
      narrowHeight: 0.82,
    }),
    domain: domainView(),
  },
  values: ({ points, uv }) => {
    const [u, v] = uv[0] as readonly [number, number];
    const surface = bezierPatch(points);
    const curvature = surfaceCurvature(surface, u, v);
    return {
      u,
      v,
      s: surface.point(u, v),
      normal: surfaceNormal(surface, u, v),
      gaussian: curvature ? curvature.gaussian : null,
    };
  },
  scene: ({ points, shading, net, normal }, { u, v, s, normal: n }) => ({
    space: [
      ground(-1, [-1.75, 1.75], [-1.75, 1.75], 0.5),
      ...axisArrows([-1.75, -1.75, -1], 0.6),
      patch("surface", sample(points), { name: "S", ...coloured(points, shading) }),
      ...patchEdges(points, "curve-rest"),
      path("u-line", "curve", bezierSteps(patchIsoCurve(points, "v", v)), { name: "u-line" }),
      path("v-line", "curve", bezierSteps(patchIsoCurve(points, "u", u)), { name: "v-line" }),
      ...(net ? netLines(points) : []),
      ...(normal ? normalMarks(s, n, 0.8) : []),
      point("s", "curve", s, { name: "s" }),
      label("s-label", "curve", s, { base: "S", args: ["u", "v"] }),
    ],
    domain: domainMarks([u, v]),
  }),
  readout: (_, { s, normal, gaussian }) => [
    { label: { base: "S", args: ["u", "v"] }, value: s },
    { label: symbol("n"), value: normal },
    { label: symbol("K"), value: gaussian },
  ],
  describe: ({ points, shading }, { u, v, s, normal, gaussian }) =>
    inBoth((lang) => {
      const at = `u = ${formatNumber(u, lang)}, v = ${formatNumber(v, lang)}`;
      const corners = [points[0]![0]!, points[3]![0]!, points[0]![3]!, points[3]![3]!]
        .map((corner) => formatPoint(corner, lang))
        .join(", ");
      if (lang === "de") {
        const bend =
          gaussian === null
            ? "Dort gibt es keine Normale."
            : `Normale ${formatPoint(normal!, lang)}, Gaußsche Krümmung ${formatNumber(gaussian, lang)}.`;
        return `Bikubisches Bézierstück mit den Ecken ${corners}. Bei ${at} liegt der Flächenpunkt ${formatPoint(s, lang)}. ${bend} Die Farbe zeigt: ${COLOURS[shading].de}.`;
      }
      const bend =
        gaussian === null
          ? "There is no normal there."
          : `Normal ${formatPoint(normal!, lang)}, Gaussian curvature ${formatNumber(gaussian, lang)}.`;
      return `Bicubic Bézier patch with the corners ${corners}. At ${at} lies the surface point ${formatPoint(s, lang)}. ${bend} The colour shows: ${COLOURS[shading].en}.`;
    }),
  states: {
    middle: { uv: [[0.5, 0.5]] },
    corner: { uv: [[0, 0]] },
    top: { camera: "top" },
    front: { camera: "front" },
    side: { camera: "side" },
    stripes: { shading: "stripes" },
    curvature: { shading: "curvature" },
    normals: { shading: "normals" },
  },
});

const COLOURS = {
  lit: { de: "Licht und Schatten", en: "light and shade" },
  normals: { de: "die Richtung der Normalen", en: "the direction of the normals" },
  curvature: { de: "die Gaußsche Krümmung", en: "the Gaussian curvature" },
  stripes: { de: "Streifen, die sich in der Fläche spiegeln", en: "stripes mirrored in the surface" },
} as const;

type Net = Parameters<typeof toFlatNet>[0];

function sample(points: Net): Pick<PatchMark, "rows" | "columns" | "positions" | "normals"> {
  const count = 3 * (STEPS + 1) ** 2;
  const [positions, normals] = [new Float32Array(count), new Float32Array(count)];
  tessellate(toFlatNet(points), positions, normals);
  return { rows: STEPS + 1, columns: STEPS + 1, positions, normals };
}

function coloured(points: Net, shading: keyof typeof COLOURS): Partial<PatchMark> {
  if (shading !== "curvature") return { shading };
  const values = new Float64Array((STEPS + 1) ** 2);
  sampleCurvature(toFlatNet(points), values);
  return { shading: "values", values, range: [-CURVATURE, CURVATURE] };
}
