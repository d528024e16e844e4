import { figureBox } from "../demo/box.ts";
import type { Demo } from "../demo/define.ts";
import type { Figure } from "../demo/figure.ts";
import { displayList } from "../render/display-list.ts";
import { svgDom } from "../render/dom/svg-dom.ts";
import { svgTree } from "../render/svg-tree.ts";
import type { Lang } from "../words/words.ts";

/** About how many facets a printed surface has: paper is finer than a still picture in the page. */
const FACETS = 2600;

/** Width of the printed picture, in drawing units. */
const WIDTH = 720;

/**
 * Before printing, the still picture in the page becomes a vector picture of the current state, for a
 * canvas prints as pixels or not at all. Gives back how to stop.
 */
export function printTwin(
  host: HTMLElement,
  demo: Demo,
  now: () => { figure: Figure; lang: Lang },
): () => void {
  const draw = () => {
    const { figure, lang } = now();
    const drawing = displayList(figure.views, figure.scene, {
      width: WIDTH,
      height: WIDTH * figureBox(demo).wide,
      lang,
      facets: FACETS,
    });
    const picture = svgDom(svgTree(drawing, { title: figure.description[lang] }), document);
    const old = host.querySelector(":scope > svg");
    if (old) old.replaceWith(picture);
    else host.append(picture);
  };
  addEventListener("beforeprint", draw);
  return () => removeEventListener("beforeprint", draw);
}
