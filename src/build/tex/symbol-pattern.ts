import { leavesOf, readTex, type TexNode } from "./nodes.ts";

/**
 * A symbol of the lesson's glossary as it is looked for in formulas: `c_i`, `B_i^n`, `p(t)`, `S_u`. The letters i, j, k, r
 * and n below or above stand for any index; all others stand for themselves.
 */
export interface SymbolPattern {
  readonly tex: string;
  readonly head: readonly string[];
  readonly sub: readonly string[] | null;
  readonly sup: readonly string[] | null;
}

/** What a pattern was found to be: how many nodes it takes, and what its index letters are there. */
export interface SymbolMatch {
  readonly length: number;
  readonly letters: ReadonlyMap<string, string>;
}

const LETTER = /^[ijkrn]$/;

export function readPattern(tex: string): SymbolPattern {
  const nodes = readTex(tex).filter((node) => node.kind !== "space");
  const cut = nodes.findIndex((node) => isScript(node));
  const head = leavesOf(cut < 0 ? nodes : nodes.slice(0, cut));
  const script = (sign: string) => {
    const at = nodes.findIndex((node) => node.kind === "sign" && node.text === sign);
    return at < 0 ? null : leavesOf(nodes.slice(at + 1, at + 2));
  };
  return { tex, head, sub: script("_"), sup: script("^") };
}

function isScript(node: TexNode | undefined): boolean {
  return node?.kind === "sign" && (node.text === "_" || node.text === "^");
}

/** Looks for the pattern at a place; a symbol with another script than the pattern's is another symbol. */
export function matchPattern(
  pattern: SymbolPattern,
  nodes: readonly TexNode[],
  start: number,
): SymbolMatch | null {
  const letters = new Map<string, string>();
  let i = start;
  const skip = () => {
    while (nodes[i]?.kind === "space") i++;
  };
  for (const leaf of pattern.head) {
    skip();
    const node = nodes[i];
    if (!node || node.kind === "group" || node.text !== leaf) return null;
    i++;
  }
  const scripts = new Map<string, readonly TexNode[]>();
  let end = i;
  for (skip(); isScript(nodes[i]); skip()) {
    const sign = writeSign(nodes[i]!);
    i++;
    skip();
    const node = nodes[i];
    if (!node) return null;
    // A power of a symbol is not part of its name.
    if (sign === "^" && pattern.sup === null && pattern.sub === null) break;
    scripts.set(sign, node.kind === "group" ? node.nodes : [node]);
    end = ++i;
  }
  const next = nodes[end];
  if (next?.kind === "sign" && next.text === "'") return null;
  for (const [sign, wanted] of [
    ["_", pattern.sub],
    ["^", pattern.sup],
  ] as const) {
    const found = scripts.get(sign);
    if ((wanted === null) !== (found === undefined)) return null;
    if (wanted && !bind(wanted, leavesOf(found!), letters)) return null;
  }
  return { length: end - start, letters };
}

function writeSign(node: TexNode): string {
  return node.kind === "group" ? "" : node.text;
}

/** `i` takes all there is; `ij` takes one sign each, or what commas separate. */
function bind(wanted: readonly string[], found: readonly string[], letters: Map<string, string>): boolean {
  const commas = found.join("").split(",");
  const parts = wanted.length === 1 ? [found.join("")] : commas.length === wanted.length ? commas : found;
  if (parts.length !== wanted.length) return false;
  return wanted.every((leaf, k) => {
    if (!LETTER.test(leaf)) return leaf === parts[k];
    letters.set(leaf, parts[k]!);
    return true;
  });
}
