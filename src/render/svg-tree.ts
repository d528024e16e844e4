import type { PathStep, XY } from "../scene/marks.ts";
import type { Box } from "../scene/view.ts";
import { paintOf } from "./paint.ts";
import type { Palette } from "./palette.ts";
import type { Drawing, Primitive, TextPrimitive, TextRun } from "./primitives.ts";
import { short } from "./short.ts";
import { FONTS, SIZE } from "./sizes.ts";
import { facetsNode } from "./svg-facets.ts";
import { type Attributes, node, type SvgNode } from "./svg-node.ts";
import { rasterNode } from "./svg-raster.ts";

export type { SvgNode } from "./svg-node.ts";

export interface SvgOptions {
  /** What is to be seen, for those who hear it. */
  readonly title: string;
  /**
   * Concrete colours, for a file of its own: presentation attributes, size, paper. Without it the SVG is
   * part of a page, takes its looks from `figureCss`, and has no size but its proportions.
   */
  readonly colours?: Palette;
  /** Leaves out the paper of a file of its own. */
  readonly transparent?: boolean;
}

/** The drawing as an SVG. */
export function svgTree(drawing: Drawing, options: SvgOptions): SvgNode {
  const { width, height } = drawing;
  const { colours, title } = options;
  const attributes: Attributes = {
    ...(colours ? { xmlns: "http://www.w3.org/2000/svg", width: short(width), height: short(height) } : {}),
    viewBox: `0 0 ${short(width)} ${short(height)}`,
    role: "img",
    "aria-label": title,
  };
  const children: SvgNode[] = [];
  if (colours) {
    children.push(node("title", {}, [title]));
    if (!options.transparent) {
      children.push(node("rect", { width: short(width), height: short(height), fill: colours.paper }));
    }
  }
  let clip: Box | undefined;
  let group: SvgNode[] = children;
  for (const primitive of drawing.primitives) {
    if (!sameBox(primitive.clip, clip)) {
      clip = primitive.clip;
      group = clip ? [] : children;
      if (clip) children.push(clipped(clip, group));
    }
    group.push(draw(primitive, colours));
  }
  return node("svg", attributes, children);
}

function sameBox(a: Box | undefined, b: Box | undefined): boolean {
  return (
    a === b ||
    (!!a && !!b && a.left === b.left && a.top === b.top && a.width === b.width && a.height === b.height)
  );
}

/** An inner svg cuts at its box and needs no id, unlike a clip path. */
function clipped({ left, top, width, height }: Box, children: SvgNode[]): SvgNode {
  const [x, y, w, h] = [left, top, width, height].map(short) as [string, string, string, string];
  return node(
    "svg",
    { x, y, width: w, height: h, viewBox: `${x} ${y} ${w} ${h}`, overflow: "hidden" },
    children,
  );
}

function draw(primitive: Primitive, colours: Palette | undefined): SvgNode {
  const look = looks(primitive, colours);
  switch (primitive.kind) {
    case "path":
      return node("path", { ...look, d: pathData(primitive.steps) });
    case "circle":
      return node("circle", {
        ...look,
        cx: short(primitive.at[0]!),
        cy: short(primitive.at[1]!),
        r: short(primitive.radius),
      });
    case "text":
      return text(primitive, look, colours);
    case "raster":
      return rasterNode(primitive);
    case "facets":
      return facetsNode(primitive, colours);
    default: {
      const unknown: never = primitive;
      throw new RangeError(`unknown primitive: ${JSON.stringify(unknown)}`);
    }
  }
}

/** Classes in a page, presentation attributes in a file of its own. */
function looks({ role, part, index, kind, opacity }: Primitive, colours: Palette | undefined): Attributes {
  if (kind === "raster" || kind === "facets") return {};
  const faded: Attributes = opacity === undefined ? {} : { opacity: short(opacity) };
  if (!colours) {
    const entry = index === undefined ? "" : ` i${((Math.trunc(index) % 10) + 10) % 10}`;
    return { class: `r-${role} p-${part}${entry}`, ...faded };
  }
  const paint = paintOf(role, part, index);
  return {
    ...faded,
    fill: paint.fill ? colours[paint.fill] : "none",
    ...(paint.fill && paint.fillOpacity < 1 ? { "fill-opacity": paint.fillOpacity } : {}),
    ...(paint.stroke
      ? {
          stroke: colours[paint.stroke],
          "stroke-width": paint.width,
          "stroke-linecap": paint.dash ? "butt" : "round",
          "stroke-linejoin": "round",
          ...(paint.strokeOpacity < 1 ? { "stroke-opacity": paint.strokeOpacity } : {}),
          ...(paint.dash ? { "stroke-dasharray": paint.dash.join(" ") } : {}),
          ...(kind === "text" ? { "paint-order": "stroke" } : {}),
        }
      : {}),
  };
}

/** Path data with two decimals; a letter is not repeated, and a minus needs no space before it. */
function pathData(steps: readonly PathStep[]): string {
  return steps
    .map(
      ([letter, ...points]) =>
        letter + (points as number[][]).map((p) => `${short(p[0]!)} ${short(p[1]!)}`).join(" "),
    )
    .join("");
}

function text({ at, anchor, runs }: TextPrimitive, look: Attributes, colours: Palette | undefined): SvgNode {
  const place: Attributes = anchor === "start" ? {} : { "text-anchor": anchor };
  const first = runs[0];
  if (first && runs.every(({ font, size }) => font === first.font && size === first.size)) {
    // One font for all: said once.
    const font = fontOf(first, colours);
    const both = colours ? font : { class: `${look.class} ${font.class}` };
    if (runs.length === 1)
      return node("text", { ...look, ...both, ...place, ...startOf(at, first) }, [first.text]);
    const spans = runs.map((run) => node("tspan", startOf(at, run), [run.text]));
    return node("text", { ...look, ...both, ...place }, spans);
  }
  const spans = runs.map((run) =>
    node("tspan", { ...fontOf(run, colours), ...startOf(at, run) }, [run.text]),
  );
  return node("text", { ...look, ...place }, spans);
}

function startOf(at: XY, { dx, dy }: TextRun): Attributes {
  return { x: short(at[0]! + dx), y: short(at[1]! + dy) };
}

function fontOf({ font, size }: TextRun, colours: Palette | undefined): Attributes {
  if (!colours) return { class: size === SIZE.label ? `f-${font}` : `f-${font} s${size}` };
  return {
    "font-family": FONTS[font],
    "font-size": short(size),
    ...(font === "math" ? { "font-style": "italic" } : {}),
  };
}
