import { attributes } from "./html.ts";
import type { Html, PredictData } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * A question, a guess, then the answer. Without a script the answer opens by itself; with one, a guess is committed and
 * the figure answers. The marks of right and wrong appear with the answer, beside the reader's guess.
 */
export function predict(data: PredictData): Html {
  const words = WORDS[data.lang];
  const { guess, figure } = data;
  const attributesOf = {
    class: "block predict",
    id: data.id,
    "data-kind": guess.kind,
    "data-figure": figure?.id,
    "data-reveal": figure?.query,
    ...(guess.kind === "number" ? { "data-value": String(guess.value) } : {}),
    ...(guess.kind === "place" ? { "data-place": guess.name } : {}),
    ...(guess.kind === "choice" ? {} : { "data-within": String(guess.within) }),
  };
  return `<div${attributes(attributesOf)}>
<div class="question"><p class="block-name"><strong>${words.blocks.predict}</strong></p>
${data.question}</div>
<fieldset><legend>${words.guess}</legend>
${guessing(data)}
</fieldset>
<button type="button" class="commit" disabled>${words.commit}</button>
<p class="result" role="status"></p>
<details class="answer"><summary>${words.answer}</summary>
${data.answer}
</details>
</div>`;
}

function guessing(data: PredictData): Html {
  const { guess, lang } = data;
  const words = WORDS[lang];
  if (guess.kind === "choice") return guess.options.map((_, i) => option(data, i)).join("\n");
  if (guess.kind === "place") return `<p class="how">${words.guessPlace}</p>`;
  const input = `<input${attributes({ type: "text", inputmode: "decimal", autocomplete: "off", name: data.id })}>`;
  return `<label class="number-guess">${words.guessNumber} ${input}</label>`;
}

function option(data: PredictData, i: number): Html {
  if (data.guess.kind !== "choice") return "";
  const words = WORDS[data.lang];
  const { html, right } = data.guess.options[i]!;
  const input = `<input${attributes({ type: "radio", name: data.id, value: String(i) })}>`;
  const verdict = right ? words.rightAnswer : words.wrongAnswer;
  return `<label${attributes({ class: right ? "option right" : "option wrong" })}>${input}<span class="option-text">${html}</span><span class="verdict">${verdict}</span></label>`;
}
