import { expect, test } from "vitest";
import { displayList } from "../../src/render/display-list.ts";
import { writeSvg } from "../../src/render/svg-text.ts";
import { type SvgNode, svgTree } from "../../src/render/svg-tree.ts";
import { palettes } from "../../src/render/theme.ts";
import { polyline } from "../../src/scene/draw.ts";
import type { RasterMark } from "../../src/scene/marks.ts";
import { EACH, scene, views } from "./all-kinds.ts";

const options = { width: 736, height: 560, lang: "de" } as const;
const plane = { plane: views.plane! };
const drawing = displayList(plane, scene, options);
const TITLE = 'Kurve mit "Griffen" <4> & mehr';

function nodes(node: SvgNode): SvgNode[] {
  return [node, ...node.children.flatMap((child) => (typeof child === "string" ? [] : nodes(child)))];
}

/** One element a line, so that a change of the picture reads as a change of lines. */
const lines = (svg: string) => `${svg.replaceAll("><", ">\n<")}\n`;

test("in a page: classes, no colours, no ids, no style sheet", async () => {
  const svg = writeSvg(svgTree(drawing, { title: TITLE }));
  expect(svg).not.toMatch(/<style|\bid=|xmlns|#[0-9a-f]{6}|width="736"/);
  expect(svg).toMatch(
    /^<svg viewBox="0 0 736 560" role="img" aria-label="Kurve mit &quot;Griffen&quot; &lt;4&gt; &amp; mehr">/,
  );
  await expect(lines(svg)).toMatchFileSnapshot("snapshots/page.svg.txt");
});

test("as a file: size, paper, colours of the theme, title", async () => {
  const svg = writeSvg(svgTree(drawing, { title: TITLE, colours: palettes.dark }));
  expect(svg).toMatch(/^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" width="736" height="560"/);
  expect(svg).toContain("<title>Kurve mit &quot;Griffen&quot; &lt;4&gt; &amp; mehr</title>");
  expect(svg).toContain(`<rect width="736" height="560" fill="${palettes.dark.paper}"/>`);
  expect(svg).not.toMatch(/class=|var\(|<style/);
  await expect(lines(svg)).toMatchFileSnapshot("snapshots/dark.svg.txt");
  const clear = writeSvg(svgTree(drawing, { title: TITLE, colours: palettes.light, transparent: true }));
  expect(clear).not.toContain("<rect width");
});

test("both show the same elements in the same places", () => {
  const shape = (node: SvgNode) =>
    nodes(node)
      .filter(({ tag }) => tag !== "svg" && tag !== "title")
      .map(({ tag, attributes: { d, cx, cy, r, x, y } }) => [tag, d, cx, cy, r, x, y].join(" "));
  const page = shape(svgTree(drawing, { title: "" }));
  expect(shape(svgTree(drawing, { title: "", colours: palettes.light, transparent: true }))).toEqual(page);
});

test("Bézier arcs are written as such, numbers with at most two decimals", () => {
  const svg = writeSvg(svgTree(drawing, { title: "" }));
  expect(svg).toMatch(/ d="M[\d. ]+C[\d. ]+Q[\d. ]+L[\d. ]+Z"/);
  expect(svg).not.toMatch(/\d\.\d{3}|NaN|undefined|Infinity|e-\d/);
});

test("cut by an inner svg with the window's own coordinates", () => {
  const inner = nodes(svgTree(drawing, { title: "" })).filter(({ tag }) => tag === "svg")[1]!;
  const { x, y, width, height, viewBox } = inner.attributes;
  expect(viewBox).toBe(`${x} ${y} ${width} ${height}`);
  expect(inner.children).toHaveLength(1);
});

test("neighbours that leave the same window share one inner svg", () => {
  const out = (key: string) =>
    polyline(key, "curve", [
      [0, 0],
      [9, 9],
    ]);
  const both = displayList(plane, { plane: [out("a"), out("b")] }, options);
  expect(nodes(svgTree(both, { title: "" })).filter(({ tag }) => tag === "svg")).toHaveLength(2);
});

test("few cells of a raster are rectangles, many a picture", () => {
  const few = nodes(svgTree(displayList(plane, { plane: [EACH.raster] }, options), { title: "" }));
  // Five of the six cells have a value.
  expect(few.filter(({ tag }) => tag === "rect")).toHaveLength(5);
  const many: RasterMark = { ...EACH.raster, columns: 40, rows: 30, values: new Float64Array(1200) };
  const [image] = nodes(svgTree(displayList(plane, { plane: [many] }, options), { title: "" })).filter(
    ({ tag }) => tag === "image",
  );
  expect(String(image!.attributes.href)).toMatch(/^data:image\/png;base64,/);
});

test("a window into space is drawn too", () => {
  const all = displayList(views, scene, options);
  const groups = nodes(svgTree(all, { title: "" })).filter(({ attributes }) => attributes.class === "facets");
  expect(groups).toHaveLength(1);
});

test("stays small: the picture of a cubic with everything around it", () => {
  expect(writeSvg(svgTree(drawing, { title: "" })).length).toBeLessThan(7000);
});
