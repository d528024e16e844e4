import { describe, expect, test } from "vitest";
import { figureOf } from "../../src/demo/figure.ts";
import { changed, initialState } from "../../src/demo/state.ts";
import { demos } from "../../src/demos/index.ts";
import { displayList } from "../../src/render/display-list.ts";
import { writeSvg } from "../../src/render/svg-text.ts";
import { svgTree } from "../../src/render/svg-tree.ts";
import { aspect } from "../../src/scene/layout.ts";

/** As wide as a figure stands in a lesson. */
const WIDTH = 736;

/** Demos of the plane; what is drawn of space has tests of its own. */
const all = (
  await Promise.all(Object.entries(demos).map(async ([id, load]) => [id, (await load()).default] as const))
).filter(([, demo]) => Object.values(demo.views).every((view) => !view.space));

// After a wanted change of a picture: npx vitest run tests/demos/pictures.test.ts --update, and look at the difference.
describe.each(all)("pictures of %s", (id, demo) => {
  const states = { initial: {}, ...demo.states };
  test.each(Object.keys(states))("%s", async (name) => {
    const state = changed(demo, initialState(demo), states[name as keyof typeof states] ?? {});
    const { scene, description } = figureOf(demo, state);
    const size = { width: WIDTH, height: WIDTH * aspect(demo.views, false) };
    const drawing = displayList(demo.views, scene, { ...size, lang: "de" });
    const svg = writeSvg(svgTree(drawing, { title: description.de }));
    await expect(`${svg.replaceAll("><", ">\n<")}\n`).toMatchFileSnapshot(`pictures/${id}.${name}.svg.txt`);
  });
});
