import type MarkdownIt from "markdown-it";
import type StateBlock from "markdown-it/lib/rules_block/state_block.mjs";
import type StateCore from "markdown-it/lib/rules_core/state_core.mjs";
import Token from "markdown-it/lib/token.mjs";
import { choices } from "../../problem.ts";
import type { Html } from "../../templates/types.ts";
import { type BlockHead, readBlockHead } from "../block-head.ts";
import { addAnchor, type LessonEnv, lineOf, report } from "../env.ts";

/** A block of a lesson, with everything that stands in it. */
export interface Block extends BlockHead {
  readonly line: number;
  readonly children: readonly Token[];
  /** The words after the name, as inline markdown, for blocks that have a title. */
  readonly title: Token | null;
}

/** Turns tokens of the block into markup. */
export interface BlockTools {
  html(tokens: readonly Token[]): Html;
  inline(token: Token | null): Html;
}

/** One kind of block; each is a file of `blocks/`. */
export interface BlockRule {
  /** How it is written, for messages. */
  readonly form: string;
  /** Whether the words after the name are a title in markdown. */
  readonly titled?: boolean;
  /** Name of the block it may only stand in. */
  readonly inside?: string;
  /** Checks and gathers, in the order of the text; what it returns is handed to `render`. */
  read(block: Block, env: LessonEnv): unknown;
  render(block: Block, env: LessonEnv, tools: BlockTools, data: unknown): Html;
}

export type BlockRules = Readonly<Record<string, BlockRule>>;

/**
 * Blocks between `::: name …` and `:::`, nested as deep as one likes with any number of colons from three on.
 * (The usual container plugin ends the outer block at the first closing line, so it cannot nest.)
 */
export function blocks(md: MarkdownIt, rules: BlockRules): void {
  const rule = (state: StateBlock, start: number, end: number, silent: boolean) =>
    readBlock(rules, state, start, end, silent);
  md.block.ruler.before("fence", "lesson_block", rule, {
    alt: ["paragraph", "reference", "blockquote", "list"],
  });
  md.core.ruler.push("fold_blocks", (state) => {
    state.tokens = fold(rules, state, state.tokens, null);
  });
  md.renderer.rules.lesson_block = (tokens, i, options, env: LessonEnv, self) => {
    const { block, data } = tokens[i]!.meta as { block: Block; data: unknown };
    return rules[block.name]!.render(
      block,
      env,
      {
        html: (inner) => self.render([...inner], options, env),
        inline: (token) => (token?.children ? self.renderInline(token.children, options, env) : ""),
      },
      data,
    );
  };
}

const OPENING = /^:{3,}\s*[^\s:]/;
const CLOSING = /^:{3,}\s*$/;

function readBlock(
  rules: BlockRules,
  state: StateBlock,
  start: number,
  end: number,
  silent: boolean,
): boolean {
  const text = (line: number) =>
    state.src.slice(state.bMarks[line]! + state.tShift[line]!, state.eMarks[line]);
  const first = text(start);
  if (!first.startsWith(":::")) return false;
  if (silent) return true;
  const env: LessonEnv = state.env;
  if (CLOSING.test(first)) {
    report(env, start + 1, '":::" closes a block, but none is open', "take the line away or open a block");
    state.line = start + 1;
    return true;
  }
  const close = findClose(text, start, end);
  if (close === null)
    report(env, start + 1, `the block "${first}" is not closed`, 'end it with a line ":::"');
  const last = close ?? end;
  const head = readBlockHead(first.replace(/^:+/, ""));
  if (typeof head === "string") {
    report(env, start + 1, `cannot read "${first}": ${head}`, "write ::: name words {#id name=value}");
  }
  const token = state.push("lesson_block_open", "", 1);
  token.map = [start, last];
  token.meta = typeof head === "string" ? null : head;
  if (token.meta && rules[token.meta.name]?.titled && token.meta.args) {
    const title = state.push("inline", "", 0);
    title.content = token.meta.args;
    title.map = [start, start + 1];
    title.children = [];
    title.meta = "title";
  }
  const [parent, max] = [state.parentType, state.lineMax];
  state.lineMax = last;
  state.md.block.tokenize(state, start + 1, last);
  state.parentType = parent;
  state.lineMax = max;
  state.push("lesson_block_close", "", -1);
  state.line = close === null ? end : close + 1;
  return true;
}

/** The line that closes the block opened at `start`; code between ``` lines does not count. */
function findClose(text: (line: number) => string, start: number, end: number): number | null {
  let depth = 1;
  let inCode = false;
  for (let line = start + 1; line < end; line++) {
    const words = text(line);
    if (/^(```|~~~)/.test(words)) inCode = !inCode;
    if (inCode) continue;
    if (OPENING.test(words)) depth++;
    else if (CLOSING.test(words) && --depth === 0) return line;
  }
  return null;
}

/** Makes each block one token with children, from the outside in; what is unknown is reported and dropped. */
function fold(rules: BlockRules, state: StateCore, tokens: Token[], parent: Block | null): Token[] {
  const env: LessonEnv = state.env;
  const folded: Token[] = [];
  for (let i = 0; i < tokens.length; i++) {
    const token = tokens[i]!;
    if (token.type !== "lesson_block_open") {
      folded.push(token);
      continue;
    }
    const close = closingToken(tokens, i);
    const inner = tokens.slice(i + 1, close);
    i = close;
    if (!token.meta) continue;
    const head: BlockHead = token.meta;
    const rule = Object.hasOwn(rules, head.name) ? rules[head.name] : undefined;
    const line = lineOf(token);
    if (!rule) {
      report(env, line, `unknown block "${head.name}"`, choices(head.name, Object.keys(rules)));
      continue;
    }
    if ((rule.inside ?? null) !== (rule.inside ? (parent?.name ?? null) : null)) {
      report(
        env,
        line,
        `"${head.name}" stands outside of "${rule.inside}"`,
        `write it inside ${rule.inside}`,
      );
      continue;
    }
    const title = inner[0]?.meta === "title" ? inner.shift()! : null;
    if (head.id !== null) addAnchor(env, head.id, line);
    const shell: Block = { ...head, line, title, children: [] };
    const block: Block = { ...shell, children: fold(rules, state, inner, shell) };
    const one = new Token("lesson_block", "", 0);
    one.block = true;
    one.map = token.map;
    one.meta = { block, data: rule.read(block, env) };
    one.children = [...block.children];
    folded.push(one);
  }
  return folded;
}

function closingToken(tokens: readonly Token[], open: number): number {
  let depth = 0;
  for (let i = open; i < tokens.length; i++) {
    if (tokens[i]!.type === "lesson_block_open") depth++;
    else if (tokens[i]!.type === "lesson_block_close" && --depth === 0) return i;
  }
  return tokens.length;
}
