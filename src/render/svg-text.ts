import type { SvgNode } from "./svg-node.ts";

const ESCAPES: Readonly<Record<string, string>> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

function escaped(text: string): string {
  return text.replace(/[&<>"]/g, (char) => ESCAPES[char]!);
}

/** The SVG as text, good both within HTML and as a file of its own. */
export function writeSvg({ tag, attributes, children }: SvgNode): string {
  const names = Object.entries(attributes)
    .map(([name, value]) => ` ${name}="${escaped(String(value))}"`)
    .join("");
  if (children.length === 0) return `<${tag}${names}/>`;
  const inner = children
    .map((child) => (typeof child === "string" ? escaped(child) : writeSvg(child)))
    .join("");
  return `<${tag}${names}>${inner}</${tag}>`;
}
