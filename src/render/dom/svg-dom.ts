import type { SvgNode } from "../svg-tree.ts";

const SVG = "http://www.w3.org/2000/svg";

/** The SVG as elements of a page. */
export function svgDom({ tag, attributes, children }: SvgNode, page: Document): SVGElement {
  const element = page.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name !== "xmlns") element.setAttribute(name, String(value));
  }
  element.append(...children.map((child) => (typeof child === "string" ? child : svgDom(child, page))));
  return element;
}
