import type { Lang } from "../../words/words.ts";
import { choices } from "../problem.ts";
import type { FigureNames } from "./figure-names.ts";
import { type LiveNumber, liveNumber, readPicture } from "./live-number.ts";
import { readTex, type TexNode, writeTex } from "./nodes.ts";
import { matchPattern, type SymbolMatch, type SymbolPattern } from "./symbol-pattern.ts";
import { tieName } from "./tie-name.ts";

/** An entry of the lesson's glossary, as formulas see it. */
export interface GlossaryEntry {
  /** From 1, in the order of the block. */
  readonly number: number;
  readonly pattern: SymbolPattern;
  /** The name with index letters, `points.i`; null for a symbol that no picture shows. */
  readonly tie: string | null;
}

/** A symbol of a formula: what it lights up, what it means. */
export interface SymbolUse {
  readonly tex: string;
  /** `figure/name`, or null. */
  readonly tie: string | null;
  readonly index: number | null;
  /** Number of its entry in the glossary, or null. */
  readonly entry: number | null;
  /** The symbol by which the glossary knows it, where only a number stands in the formula. */
  readonly known?: string | null;
  /** `figure/path` of its value, where that is not found under its name. */
  readonly value?: string | null;
}

export interface TexContext {
  readonly lang: Lang;
  readonly glossary: readonly GlossaryEntry[];
  /** The figure that names without one belong to; null if the lesson has none. */
  readonly figure: string | null;
  /** All figures of the lesson, that one first, the others by their distance from the formula. */
  readonly figures: readonly string[];
  names(figure: string): FigureNames | null;
}

/** A formula with its symbols marked for KaTeX. */
export interface Annotated {
  readonly tex: string;
  readonly symbols: readonly SymbolUse[];
  /** In the order of the placeholders `@0@`, `@1@`, … in the TeX. */
  readonly live: readonly LiveNumber[];
  readonly problems: readonly { readonly message: string; readonly remedy: string }[];
}

/** Commands whose arguments are not mathematics, and how many they have. */
const RAW: Readonly<Record<string, number>> = {
  "\\text": 1,
  "\\mathrm": 1,
  "\\operatorname": 1,
  "\\num": 1,
  "\\begin": 1,
  "\\end": 1,
  "\\hspace": 1,
  "\\tag": 1,
  "\\color": 1,
};
/** Commands that take what follows, even without braces; a macro must not come between. */
const TAKES: Readonly<Record<string, number>> = {
  "\\frac": 2,
  "\\tfrac": 2,
  "\\dfrac": 2,
  "\\binom": 2,
  "\\sqrt": 1,
  "\\tilde": 1,
  "\\hat": 1,
  "\\bar": 1,
  "\\vec": 1,
  "\\dot": 1,
  "\\ddot": 1,
  "\\mathbf": 1,
  "\\underbrace": 1,
  "\\overbrace": 1,
  "\\overline": 1,
  "\\norm": 1,
  "\\abs": 1,
};

/**
 * Marks the symbols of a formula: those that the author ties with `\tie{name}{x}`, those of the glossary wherever they
 * stand, and the places of numbers that follow the figure, `\live{name}{0.00}`.
 */
export function annotate(source: string, context: TexContext): Annotated {
  const symbols: SymbolUse[] = [];
  const live: LiveNumber[] = [];
  const problems: { message: string; remedy: string }[] = [];
  const report = (message: string, remedy: string) => void problems.push({ message, remedy });

  const walk = (nodes: readonly TexNode[]): string => {
    let out = "";
    for (let i = 0; i < nodes.length; ) {
      const node = nodes[i]!;
      const text = node.kind === "group" ? "" : node.text;
      if (node.kind === "group") {
        out += `{${walk(node.nodes)}}`;
        i++;
      } else if (text === "\\tie" || text === "\\live") {
        const [groups, end] = groupsAfter(nodes, i + 1, 2);
        if (groups.length < 2) {
          const form = text === "\\tie" ? "\\tie{name}{x}" : "\\live{name}{0.00}";
          report(`${text} has not its two arguments`, `write ${form}`);
          return out + writeTex(nodes.slice(i + 1));
        }
        const name = writeTex(groups[0]!).trim();
        out += text === "\\tie" ? tie(name, groups[1]!) : number(name, writeTex(groups[1]!).trim());
        i = end;
      } else if (/^\\html/.test(text)) {
        report(`${text} is not for authors`, "write \\tie{name}{x}");
        i++;
      } else if (text in RAW) {
        const [groups, end] = groupsAfter(nodes, i + 1, RAW[text]! + (opensArray(nodes[i + 1]) ? 1 : 0));
        out += text + groups.map((group) => `{${writeTex(group)}}`).join("");
        i = groups.length > 0 ? end : i + 1;
      } else if (text === "\\\\" && nodes[i + 1] && writeTex([nodes[i + 1]!]) === "[") {
        const end = nodes.findIndex((one, k) => k > i && writeTex([one]) === "]") + 1;
        out += writeTex(nodes.slice(i, end));
        i = end;
      } else if (text in TAKES || text === "_" || text === "^") {
        out += text;
        i++;
        for (let k = TAKES[text] ?? 1; k > 0 && i < nodes.length; k--) {
          for (; nodes[i]?.kind === "space"; i++) out += writeTex([nodes[i]!]);
          const next = nodes[i++];
          if (next?.kind === "group") out += `{${walk(next.nodes)}}`;
          else if (next) out += text in TAKES ? next.text : scripted(next);
        }
      } else {
        const found = find(nodes, i);
        if (!found) {
          out += text;
          i++;
          continue;
        }
        const body = nodes.slice(i, i + found.match.length);
        out += glossary(found.entry, found.match, body);
        i += found.match.length;
      }
    }
    return out;
  };

  /** A single sign below or above: braces, where something is put around it. */
  const scripted = (node: TexNode): string => {
    const text = walk([node]);
    return text === writeTex([node]) ? text : `{${text}}`;
  };
  const find = (nodes: readonly TexNode[], i: number) => {
    for (const entry of context.glossary) {
      const match = matchPattern(entry.pattern, nodes, i);
      if (match) return { entry, match };
    }
    return null;
  };
  const glossary = (entry: GlossaryEntry, match: SymbolMatch, body: readonly TexNode[]): string => {
    // What the formula's own figure does not show, another one near by may.
    for (const figure of entry.tie ? context.figures : []) {
      const names = context.names(figure);
      const name = names && tieName(entry.tie!, match.letters, names);
      if (name) return wrap(body, `${figure}/${name}`, entry.number, names.names.get(name)?.index);
    }
    return wrap(body, null, entry.number, null);
  };
  /** Symbols within a symbol, the t of p(t), stay symbols of their own. */
  const wrap = (
    body: readonly TexNode[],
    tie: string | null,
    entry: number | null,
    index: number | null | undefined,
  ): string => {
    symbols.push({ tex: writeTex(body), tie, index: index ?? null, entry });
    const data = [
      tie && `tie=${tie}`,
      entry && `symbol=${entry}`,
      tie && index != null && `index=${index % 10}`,
    ];
    const [first, ...rest] = body;
    const scripts = rest.some((one) => writeTex([one]) === "_" || writeTex([one]) === "^");
    const inner = scripts || !first ? writeTex(body) : writeTex([first]) + walk(rest);
    return `\\htmlData{${data.filter(Boolean).join()}}{${inner}}`;
  };
  /** The figure and the name that an author has written; null, with a problem, if there is no such thing. */
  const resolve = (written: string): { figure: string; name: string; names: FigureNames } | null => {
    const cut = written.indexOf("/");
    const figure = cut < 0 ? context.figure : written.slice(0, cut);
    const name = written.slice(cut + 1);
    const names = figure === null ? null : context.names(figure);
    if (figure === null || !names) {
      const remedy = choices(figure ?? "", context.figures);
      report(
        `"${written}" is tied to no figure${figure === null ? "" : `: there is no "${figure}"`}`,
        remedy,
      );
      return null;
    }
    return { figure, name, names };
  };
  const tie = (written: string, body: readonly TexNode[]): string => {
    const found = resolve(written);
    const name = found && tieName(found.name, new Map(), found.names, true);
    if (found && !name) {
      const known = [...found.names.names.keys()];
      report(`the figure "${found.figure}" has no "${found.name}" to tie to`, choices(found.name, known));
    }
    if (!found || !name) return writeTex(body);
    const whole = find(body, 0);
    const isSymbol = whole !== null && whole.match.length === body.length;
    const known = isSymbol ? null : knownAs(found.name, context.glossary);
    const entry = isSymbol ? whole.entry.number : (known?.entry ?? null);
    const index = found.names.names.get(name)?.index;
    const before = live.length;
    const data = [
      `tie=${found.figure}/${name}`,
      entry && `symbol=${entry}`,
      index !== undefined && `index=${index % 10}`,
    ];
    const place = symbols.length;
    const inner = isSymbol ? writeTex(body) : walk(body);
    symbols.splice(place, 0, {
      tex: writeTex(body),
      tie: `${found.figure}/${name}`,
      index: index ?? null,
      entry,
      known: known?.tex ?? null,
      value: live.length > before ? live[before]!.source : null,
    });
    return `\\htmlData{${data.filter(Boolean).join()}}{${inner}}`;
  };
  const number = (written: string, picture: string): string => {
    const form = readPicture(picture);
    if (!form)
      report(`"${picture}" is no picture of a number`, "write 0.00, or -0.00 with a place for the sign");
    const found = resolve(written);
    if (!found || !form) return "0";
    const value = found.names.value(found.name);
    const isPoint = Array.isArray(value) && value.every((x) => typeof x === "number");
    if (typeof value !== "number" && !isPoint) {
      const known = [...found.names.names.keys()];
      report(`the figure "${found.figure}" computes no number "${found.name}"`, choices(found.name, known));
      return "0";
    }
    live.push(liveNumber(`${found.figure}/${found.name}`, value as number | number[], form, context.lang));
    return `\\htmlData{live=${live.length - 1}}{\\text{@${live.length - 1}@}}`;
  };

  return { tex: walk(readTex(source)), symbols, live, problems };
}

/** The symbol that a name has in the glossary: `points.2` is c_2 where the glossary ties c_i to `points.i`. */
function knownAs(name: string, glossary: readonly GlossaryEntry[]): { tex: string; entry: number } | null {
  for (const { tie, pattern, number } of glossary) {
    const letters = new Map<string, string>();
    const [form, given] = [tie?.split(".") ?? [], name.split(".")];
    const fits = (segment: string, k: number) => {
      if (!/^[ijkr]$/.test(segment)) return segment === given[k];
      letters.set(segment, given[k]!);
      return /^\d+$/.test(given[k] ?? "");
    };
    if (form.length !== given.length || !form.every(fits)) continue;
    const tex = pattern.tex.replace(
      /(?<=[_^{])[ijkr](?![a-z])/g,
      (letter) => `{${letters.get(letter) ?? letter}}`,
    );
    return { tex, entry: number };
  }
  return null;
}

function opensArray(node: TexNode | undefined): boolean {
  return node?.kind === "group" && /^(array|darray|subarray|alignedat)$/.test(writeTex(node.nodes));
}

/** The next groups, and where they end; fewer if something else comes first. */
function groupsAfter(
  nodes: readonly TexNode[],
  start: number,
  count: number,
): [(readonly TexNode[])[], number] {
  const groups: (readonly TexNode[])[] = [];
  let i = start;
  while (groups.length < count) {
    while (nodes[i]?.kind === "space") i++;
    const node = nodes[i];
    if (node?.kind !== "group") break;
    groups.push(node.nodes);
    i++;
  }
  return [groups, i];
}
