import { teapot, teapotParts } from "../data/teapot.ts";
import { boolean, choice, defineDemo, number, points } from "../demo/index.ts";
import { bezierPatch, limitNormal, patchTessellator, surfaceNormal, toFlatNet } from "../math/index.ts";
import { label, point } from "../scene/draw.ts";
import { symbol, wording } from "../scene/label.ts";
import type { Mark, PatchMark } from "../scene/marks.ts";
import { normalMarks } from "../scene/normal-marks.ts";
import { netLines, patchEdges } from "../scene/patch-lines.ts";
import { spaceView } from "../scene/space.ts";
import { axisArrows, ground, patch } from "../scene/surfaces.ts";
import { domainMarks, domainView } from "../scene/uv-domain.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import { inBoth, type Words } from "../words/words.ts";

const PART_NAMES: Readonly<Record<(typeof teapotParts)[number]["id"], Words>> = {
  rim: { de: "Rand", en: "rim" },
  body: { de: "Bauch", en: "body" },
  handle: { de: "Henkel", en: "handle" },
  spout: { de: "Tülle", en: "spout" },
  lid: { de: "Deckel", en: "lid" },
  bottom: { de: "Boden", en: "bottom" },
};

/** Quads along each side of a patch. */
const STEPS = 16;

/** The Utah teapot: 32 bicubic Bézier patches, all of them, and each with its control net. */
export default defineDemo({
  id: "teapot",
  title: { de: "Die Teekanne aus 32 Flächenstücken", en: "The teapot of 32 patches" },
  params: {
    patch: number({
      initial: 17,
      min: 1,
      max: 32,
      step: 1,
      whole: true,
      label: { de: "Flächenstück Nr.", en: "Patch no." },
      primary: true,
      animate: 16,
    }),
    show: choice({
      initial: "all",
      label: { de: "Gezeigt werden", en: "Shown are" },
      options: [
        { id: "all", label: { de: "alle Stücke", en: "all patches" } },
        {
          id: "part",
          label: { de: "der Teil, zu dem das Stück gehört", en: "the part the patch belongs to" },
        },
        { id: "one", label: { de: "nur das Stück", en: "the patch alone" } },
      ],
    }),
    net: boolean({ initial: true, label: { de: "Kontrollnetz zeigen", en: "Show the control net" } }),
    edges: boolean({ initial: false, label: { de: "Alle Ränder zeigen", en: "Show all edges" } }),
    normal: boolean({ initial: false, label: { de: "Normale zeigen", en: "Show the normal" } }),
    shading: choice({
      initial: "lit",
      label: { de: "Farbe der Fläche", en: "Colour of the surface" },
      options: [
        { id: "lit", label: { de: "Licht", en: "light" } },
        { id: "normals", label: { de: "Richtung der Normalen", en: "direction of the normals" } },
        { id: "stripes", label: { de: "Spiegelstreifen", en: "reflection stripes" } },
      ],
    }),
    uv: points({
      initial: [[0.5, 0.5]],
      label: { de: "Parameter u und v", en: "Parameters u and v" },
      names: [{ base: "u, v" }],
      axes: ["u", "v"],
      view: "domain",
      x: [0, 1],
      y: [0, 1],
      indexed: false,
    }),
  },
  views: {
    space: spaceView({
      label: { de: "Teekanne", en: "Teapot" },
      target: [0.2, 0, 1.45],
      radius: 2.35,
      yaw: 24,
      pitch: 20,
      height: 0.56,
      narrowHeight: 0.72,
    }),
    domain: domainView({ beside: 0.24 }),
  },
  values: ({ patch: chosen, uv }) => {
    const [u, v] = uv[0] as readonly [number, number];
    const surface = bezierPatch(teapot[chosen - 1]!);
    const normal = surfaceNormal(surface, u, v);
    return {
      part: partOf(chosen).id,
      u,
      v,
      s: surface.point(u, v),
      normal,
      limit: normal ?? limitNormal(surface, u, v),
    };
  },
  scene: ({ patch: chosen, show, net, edges, normal, shading }, { u, v, s, normal: n, limit }) => {
    const control = teapot[chosen - 1]!;
    const { from, to } =
      show === "all" ? { from: 0, to: 32 } : show === "part" ? partOf(chosen) : ALONE(chosen);
    const pieces = teapot.slice(from, to).map((_, k): Mark => {
      const accent = from + k === chosen - 1;
      return patch(`patch-${from + k}`, samples()[from + k]!, {
        shading,
        accent,
        name: `patch.${from + k + 1}`,
      });
    });
    return {
      space: [
        ground(0, [-3.5, 3.5], [-2.5, 2.5], 0.5),
        ...axisArrows([-3.5, -2.5, 0], 0.8),
        ...pieces,
        ...(edges
          ? teapot.slice(from, to).flatMap((one, k) => patchEdges(one, "mesh", `edge-${from + k}`))
          : []),
        ...patchEdges(control, "curve"),
        ...(net ? netLines(control) : []),
        ...(net ? controlPoints(control) : []),
        ...(normal ? normalMarks(s, n, 0.8, limit) : []),
        point("s", "curve", s, { name: "s" }),
        label("s-label", "curve", s, { base: "S", args: ["u", "v"] }),
      ],
      domain: domainMarks([u, v]),
    };
  },
  readout: ({ patch: chosen }, { s, normal }) => [
    { label: wording(PART_NAMES[partOf(chosen).id]), value: chosen, digits: 0 },
    { label: { base: "S", args: ["u", "v"] }, value: s },
    { label: symbol("n"), value: normal },
  ],
  describe: ({ patch: chosen, show }, { u, v, s, normal }) =>
    inBoth((lang) => {
      const { id, from, to } = partOf(chosen);
      const name = PART_NAMES[id];
      const at = `u = ${formatNumber(u, lang)}, v = ${formatNumber(v, lang)}`;
      if (lang === "de") {
        const seen = {
          all: "Die Teekanne aus 32 bikubischen Bézierstücken.",
          part: `Der ${to - from}-teilige Abschnitt „${name.de}“ der Teekanne.`,
          one: "Ein einzelnes Stück der Teekanne.",
        }[show];
        const up = normal
          ? `die Normale ist ${formatPoint(normal, lang)}`
          : "dort verschwindet das Kreuzprodukt der Ableitungen, es gibt keine Normale";
        return `${seen} Hervorgehoben ist Stück ${chosen} mit seinem Kontrollnetz (Teil: ${name.de}). Bei ${at} liegt der Flächenpunkt ${formatPoint(s, lang)}; ${up}.`;
      }
      const seen = {
        all: "The teapot of 32 bicubic Bézier patches.",
        part: `The part “${name.en}” of the teapot, ${to - from} patches.`,
        one: "A single patch of the teapot.",
      }[show];
      const up = normal
        ? `the normal is ${formatPoint(normal, lang)}`
        : "there the cross product of the derivatives vanishes, and there is no normal";
      return `${seen} Patch ${chosen} is highlighted with its control net (part: ${name.en}). At ${at} lies the surface point ${formatPoint(s, lang)}; ${up}.`;
    }),
  states: {
    handle: { patch: 13, show: "part" },
    spout: { patch: 17, show: "part" },
    lid: { patch: 21, show: "part", normal: true, uv: [[0.5, 0]], camera: [20, 35, 9.4] },
    body: { patch: 6, show: "part" },
    alone: { show: "one" },
    edges: { edges: true, net: false },
    stripes: { shading: "stripes", net: false },
  },
});

const partOf = (chosen: number) => teapotParts.find(({ to }) => chosen <= to)!;
const ALONE = (chosen: number) => ({ from: chosen - 1, to: chosen });

let sampled: readonly Pick<PatchMark, "rows" | "columns" | "positions" | "normals">[] | undefined;

/** The samples of all patches: they never change, so they are computed once and kept by every renderer. */
function samples() {
  if (!sampled) {
    const tessellate = patchTessellator(3, 3, STEPS, STEPS);
    const count = 3 * (STEPS + 1) ** 2;
    sampled = teapot.map((net) => {
      const [positions, normals] = [new Float32Array(count), new Float32Array(count)];
      tessellate(toFlatNet(net), positions, normals);
      return { rows: STEPS + 1, columns: STEPS + 1, positions, normals };
    });
  }
  return sampled;
}

/** The control points of the chosen patch; those that coincide are drawn once. */
function controlPoints(net: (typeof teapot)[number]): Mark[] {
  const seen = new Set<string>();
  return net.flatMap((row, i) =>
    row.flatMap((at, j): Mark[] => {
      if (seen.has(String(at))) return [];
      seen.add(String(at));
      return [point(`c-${i}-${j}`, "control-polygon", at, { size: "small", name: `c.${i}.${j}` })];
    }),
  );
}
