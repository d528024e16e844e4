import type { Lang } from "../../words/words.ts";
import { leavesOf, readTex, type TexNode, writeTex } from "./nodes.ts";

const WORDS = {
  de: { power: "hoch", over: "durch", prime: "Strich" },
  en: { power: "to the power", over: "over", prime: "prime" },
} as const;

/** A short piece of TeX as it may be spoken: `c_1` is "c 1", `(1-t)^3` "(1 − t) hoch 3". */
export function sayTex(source: string, lang: Lang): string {
  return say(readTex(source), lang).replace(/\s+/g, " ").trim();
}

function say(nodes: readonly TexNode[], lang: Lang): string {
  const words = WORDS[lang];
  let text = "";
  // Above a letter with an index, a number is a degree, not a power.
  let indexed = false;
  for (let i = 0; i < nodes.length; i++) {
    const node = nodes[i]!;
    if (node.kind === "group") text += say(node.nodes, lang);
    else if (node.kind === "space" || /^\\[,;:! ]$|^\\[bB]ig[lr]?$|^\\left$|^\\right$/.test(node.text))
      text += " ";
    else if (/^\\[td]?frac$/.test(node.text)) {
      const [above, below] = nodes.slice(i + 1, i + 3);
      text += ` ${say(above ? [above] : [], lang)} ${words.over} ${say(below ? [below] : [], lang)} `;
      i += 2;
    } else if (node.text === "_") {
      text += " ";
      indexed = true;
    } else if (node.text === "^") {
      text += indexed ? " " : ` ${words.power} `;
    } else if (node.text === "'") text += ` ${words.prime} `;
    else if (node.text === "-") text += " − ";
    else if (node.kind === "command") text += ` ${node.text.slice(1)} `;
    else {
      text += node.text;
      if (node.text === ")") indexed = false;
    }
  }
  return text;
}

/** What is left of TeX without what only ties it to pictures: for comparing, and for those who copy it. */
export function plainTex(source: string): string {
  return writeTex(plain(readTex(source)));
}

function plain(nodes: readonly TexNode[]): TexNode[] {
  const result: TexNode[] = [];
  for (let i = 0; i < nodes.length; i++) {
    const node = nodes[i]!;
    if (node.kind === "command" && (node.text === "\\tie" || node.text === "\\live")) {
      const groups = nodes.slice(i + 1).filter((one) => one.kind !== "space");
      const body = groups[1];
      if (node.text === "\\tie" && body?.kind === "group") result.push(...plain(body.nodes));
      i = body ? nodes.indexOf(body) : nodes.length;
    } else if (node.kind === "group") result.push({ kind: "group", nodes: plain(node.nodes) });
    else result.push(node);
  }
  return result;
}

/** TeX as one compares it: without ties, braces that only carried a live number, and spaces of any kind. */
export function bareTex(source: string): string {
  return writeTex(bare(readTex(plainTex(source))));
}

function bare(nodes: readonly TexNode[]): TexNode[] {
  const dense = nodes.filter((node) => node.kind !== "space" && !/^\\(?:q?quad|[,;:! ])$/.test(textOf(node)));
  const result: TexNode[] = [];
  for (let i = 0; i < dense.length; i++) {
    const node = dense[i]!;
    const [body, below, words] = dense.slice(i + 1, i + 4);
    const empty = words?.kind === "group" && leavesOf(words.nodes).length === 0;
    if (
      textOf(node) === "\\underbrace" &&
      body?.kind === "group" &&
      below &&
      textOf(below) === "_" &&
      empty
    ) {
      result.push(...bare(body.nodes));
      i += 3;
    } else result.push(node.kind === "group" ? { kind: "group", nodes: bare(node.nodes) } : node);
  }
  return result;
}

function textOf(node: TexNode): string {
  return node.kind === "group" ? "" : node.text;
}
