import type Token from "markdown-it/lib/token.mjs";
import type { Demo } from "../../../demo/index.ts";
import type { State } from "../../../demo/param.ts";
import { changed } from "../../../demo/state.ts";
import { choices } from "../../problem.ts";
import { predict as template } from "../../templates/predict.ts";
import type { Guess, PredictData } from "../../templates/types.ts";
import { type LessonEnv, report } from "../env.ts";
import { readState } from "../read-state.ts";
import type { Block, BlockRule } from "../rules/blocks.ts";

const ATTRIBUTES = ["figure", "reveal", "number", "place", "within", "at"];

/** What is guessed; null for a choice from the list in the block. */
type Plan = Exclude<Guess, { kind: "choice" }> | null;

/**
 * `::: predict {#id figure=fig reveal="t=0.5"}`: a question, a guess, then the figure goes into the state `reveal` and
 * answers. The guess is a choice from a list of `- [ ] wrong` and `- [x] right`; or a number, `number=0.6 within=0.05`; or
 * a mark placed in the picture, `place=p within=0.2`, which is compared with the value p of the figure in that state.
 */
export const predict: BlockRule = {
  form: '::: predict {#id figure=fig reveal="t=0.5"}',
  read: (block, env) => {
    const { attributes } = block;
    env.skeleton.push({
      line: block.line,
      sign: `predict #${block.id ?? ""} ${[...attributes].join(" ")}`.trim(),
    });
    const say = (message: string, remedy: string) => report(env, block.line, message, remedy);
    if (block.id === null) say("the prediction has no id", `write ${predict.form}`);
    for (const name of attributes.keys()) {
      if (!ATTRIBUTES.includes(name)) say(`a prediction has no "${name}"`, choices(name, ATTRIBUTES));
    }
    const body = takeApart(block.children);
    const guess = readGuess(attributes, say);
    if (body.answer.length === 0) say("the prediction has no answer", "end it with ::: answer … :::");
    const right = body.options.filter((option) => option.right).length;
    if (guess === null && (body.options.length < 2 || right !== 1)) {
      say("a choice needs two answers or more, one of them right", "write - [ ] wrong and - [x] right");
    }
    if (guess !== null && body.options.length > 0) {
      say("a number or a place is guessed without a list", "take away the list, or number and place");
    }
    // Where the reader's mark begins; its figure may stand after the question.
    const figure = attributes.get("figure");
    if (guess?.kind === "place" && figure) env.guesses.set(figure, attributes.get("at") ?? "");
    return { body, guess };
  },
  render: (block, env, tools, data) => {
    const { body, guess } = data as { body: Body; guess: Plan };
    const options = body.options.map(({ words, right }) => ({ html: tools.inline(words), right }));
    return `${template({
      lang: env.lang,
      id: block.id ?? "",
      question: tools.html(body.question),
      guess: guess ?? { kind: "choice", options },
      figure: readFigure(block, env, guess),
      answer: tools.html(body.answer),
    })}\n`;
  },
};

/** `::: answer` inside a prediction: what is to be seen, and why. */
export const answer: BlockRule = {
  form: "::: answer",
  inside: "predict",
  read: () => null,
  render: (block, _env, tools) => tools.html(block.children),
};

interface Body {
  readonly question: readonly Token[];
  readonly options: readonly { readonly words: Token; readonly right: boolean }[];
  readonly answer: readonly Token[];
}

/** Question, list of answers to choose from, answer. A list without boxes belongs to the question. */
function takeApart(children: readonly Token[]): Body {
  const question: Token[] = [];
  const options: { words: Token; right: boolean }[] = [];
  const answer: Token[] = [];
  for (let i = 0; i < children.length; i++) {
    const token = children[i]!;
    const end = token.type === "bullet_list_open" ? endOfList(children, i) : i;
    const items = children.slice(i, end).filter((one) => one.type === "inline");
    if (items.length > 0 && items.every((item) => BOX.test(item.content))) {
      options.push(...items.map(readOption));
      i = end;
    } else if (token.meta?.block?.name === "answer") answer.push(token);
    else question.push(token);
  }
  return { question, options, answer };
}

const BOX = /^\[([ x])\]\s+/;

function readOption(words: Token): { words: Token; right: boolean } {
  const right = BOX.exec(words.content)![1] === "x";
  const first = words.children?.[0];
  if (first) first.content = first.content.replace(BOX, "");
  return { words, right };
}

function endOfList(tokens: readonly Token[], open: number): number {
  const level = tokens[open]!.level;
  return tokens.findIndex(
    (token, i) => i > open && token.type === "bullet_list_close" && token.level === level,
  );
}

type Say = (message: string, remedy: string) => void;

function readGuess(attributes: Block["attributes"], say: Say): Plan {
  const [number, place] = [attributes.get("number"), attributes.get("place")];
  if (number === undefined && place === undefined) return null;
  const within = Number(attributes.get("within"));
  if (!(within > 0)) say("how near must the guess be?", "write within=0.1");
  if (place !== undefined) return { kind: "place", name: place, within };
  if (!Number.isFinite(Number(number))) say(`"${number}" is no number`, "write number=0.6");
  return { kind: "number", value: Number(number), within };
}

/** The figure that answers and its state, checked when all figures are known. */
function readFigure(block: Block, env: LessonEnv, guess: Plan): PredictData["figure"] {
  const say = (message: string, remedy: string) => report(env, block.line, message, remedy);
  const [id, reveal = ""] = [block.attributes.get("figure"), block.attributes.get("reveal")];
  if (id === undefined) {
    if (guess?.kind === "place" || reveal !== "") say("which figure answers?", "write figure=figure-id");
    return null;
  }
  const figure = env.figures.find((one) => one.id === id);
  const demo = figure && env.demos.get(figure.demo);
  if (!figure) {
    const ids = env.figures.map((one) => one.id);
    say(`no figure "${id}" in this lesson`, choices(id, ids));
  }
  if (!demo || !figure?.own) return null;
  const state = readState(demo, reveal);
  for (const { message, remedy } of state.problems) say(`figure "${id}": ${message}`, remedy);
  if (guess?.kind === "place")
    checkPlace(demo, changed(demo, figure.own, state.patch), guess.name, block, say);
  return { id, query: state.query };
}

function checkPlace(demo: Demo, state: State, name: string, block: Block, say: Say): void {
  const place = demo.values(state)[name];
  if (!Array.isArray(place) || !place.every((x) => typeof x === "number")) {
    say(`"${name}" is no point of ${demo.id}`, choices(name, Object.keys(demo.values(state))));
  }
  if (demo.params.guess) say(`${demo.id} has a parameter "guess" of its own`, "ask for something else");
  const [view, at = ""] = (block.attributes.get("at") ?? "").split(" ");
  if (!view || !Object.hasOwn(demo.views, view) || !/^-?[\d.]+,-?[\d.]+$/.test(at)) {
    const form = `write at="${Object.keys(demo.views)[0]} 0,0"; windows: ${Object.keys(demo.views).join(", ")}`;
    say("where does the reader's mark begin?", form);
  }
}
