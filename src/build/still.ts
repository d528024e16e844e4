import { figureBox } from "../demo/box.ts";
import { figureOf } from "../demo/figure.ts";
import { displayList } from "../render/display-list.ts";
import { writeSvg } from "../render/svg-text.ts";
import { svgTree } from "../render/svg-tree.ts";
import type { Still } from "./markdown/env.ts";

/** Width of a still picture in its own pixels: that of a figure beside the text on a wide screen. */
const WIDTH = 736;

/** The still picture of a demo in a state, with the space it takes. */
export const still: Still = (demo, state, lang) => {
  const box = figureBox(demo);
  const height = Math.round(WIDTH * box.wide);
  const figure = figureOf(demo, state);
  const drawing = displayList(figure.views, figure.scene, { width: WIDTH, height, lang });
  return { box, svg: writeSvg(svgTree(drawing, { title: figure.description[lang] })) };
};
