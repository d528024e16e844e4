import { attributes, lines } from "./html.ts";
import type { FigureData, Html } from "./types.ts";

/** A demo with its still picture, as it stands in a page before, or without, any script. */
export function curveDemo(data: FigureData): Html {
  const { wide, narrow, belowWide, belowNarrow } = data.box;
  const style = `--wide:${wide};--narrow:${narrow};--below-wide:${belowWide}px;--below-narrow:${belowNarrow}px`;
  return `<curve-demo${attributes({ demo: data.demo, ...data.attributes, style })}>${data.svg}</curve-demo>`;
}

/** A figure of the text: anchor, demo, caption; on paper another caption, if there is one. */
export function figure(data: FigureData): Html {
  return lines(
    `<figure${attributes({ id: data.id, class: "figure" })}>`,
    curveDemo(data),
    data.caption && `<figcaption>${captions(data)}</figcaption>`,
    "</figure>",
  );
}

function captions({ caption, printCaption }: FigureData): Html {
  if (!printCaption) return caption;
  return `<div class="on-screen">${caption}</div><div class="on-paper">${printCaption}</div>`;
}
