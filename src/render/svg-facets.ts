import type { Facet, FacetColour } from "../scene/marks.ts";
import { facetRgb, TONES } from "./facet-colour.ts";
import type { Palette } from "./palette.ts";
import type { FacetsPrimitive } from "./primitives.ts";
import type { SvgNode } from "./svg-node.ts";

/** Coordinates are counted in halves of a pixel. */
const UNIT = 0.5;
/** A rim in the facet's own colour closes the hair lines between neighbours. */
const RIM = 0.8;
/** Tones of a shaded side in a page, where the theme mixes the colours. */
const TONE_COUNT = 24;

/**
 * Surfaces as a group of paths, one for each run of facets of one colour. In a page the theme's tones are classes
 * (`facetsCss`), so that the picture follows light, dark, print and forced colours; elsewhere colours are written out.
 */
export function facetsNode({ facets }: FacetsPrimitive, colours: Palette | undefined): SvgNode {
  const children: SvgNode[] = [];
  let look = "";
  let data = "";
  const flush = () => {
    if (data === "") return;
    const paint = look.startsWith("#") ? { fill: look, stroke: look } : { class: look };
    children.push({ tag: "path", attributes: { ...paint, d: data }, children: [] });
    data = "";
  };
  for (const { corners, colour } of facets) {
    const next = colours ? hex(facetRgb(colour, colours)) : toneOf(colour);
    if (next !== look) flush();
    look = next;
    data += outline(corners);
  }
  flush();
  return {
    tag: "g",
    attributes: {
      class: "facets",
      transform: `scale(${UNIT})`,
      "stroke-width": RIM / UNIT,
      "stroke-linejoin": "round",
    },
    children,
  };
}

/** The rules of `facetsNode`'s classes: `scope` selects the svg elements. */
export function facetsCss(scope: string): string {
  const rules = Object.entries(TONES).map(
    ([side, [dim, lit]]) =>
      `${scope} .t-${side}{--q:color-mix(in srgb,var(--${lit}) var(--k),var(--${dim}));fill:var(--q);stroke:var(--q)}`,
  );
  for (let k = 0; k < TONE_COUNT; k++) {
    rules.push(`${scope} .k${k}{--k:${Math.round((100 * k) / (TONE_COUNT - 1))}%}`);
  }
  return rules.join("\n");
}

function toneOf(colour: FacetColour): string {
  if ("between" in colour) return `t-${colour.between} k${Math.round(colour.share * (TONE_COUNT - 1))}`;
  if ("map" in colour && colour.share === null) return "t-front k0";
  // Maps are the same in every theme.
  return hex("rgb" in colour ? colour.rgb : facetRgb(colour, {} as Palette));
}

function hex(rgb: readonly number[]): string {
  return `#${rgb.map((x) => x.toString(16).padStart(2, "0")).join("")}`;
}

/** A closed outline in relative steps of half a pixel: whole numbers are short, and neighbours round alike. */
function outline(corners: Facet["corners"]): string {
  let text = "";
  let [lastX, lastY] = [0, 0];
  corners.forEach(([x, y], k) => {
    const [px, py] = [Math.round(x! / UNIT), Math.round(y! / UNIT)];
    text += `${k === 0 ? "M" : k === 1 ? "l" : spaced(px - lastX)}${px - lastX}${spaced(py - lastY)}${py - lastY}`;
    [lastX, lastY] = [px, py];
  });
  return `${text}z`;
}

/** A minus needs no space before it. */
const spaced = (value: number) => (value < 0 ? "" : " ");
