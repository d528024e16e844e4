import { attributes } from "./html.ts";
import type { Html, PredictData } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * A question, a guess, then the answer; all of it works without a script. The marks of right and wrong
 * appear with the answer, beside the reader's guess.
 */
export function predict(data: PredictData): Html {
  const words = WORDS[data.lang];
  const options =
    data.options.length === 0
      ? ""
      : `<fieldset><legend>${words.guess}</legend>\n${data.options.map((_, i) => option(data, i)).join("\n")}\n</fieldset>\n`;
  return `<div${attributes({ class: "block predict", id: data.id })}>
<div class="question"><p class="block-name"><strong>${words.blocks.predict}</strong></p>
${data.question}</div>
${options}<details class="answer"><summary>${words.answer}</summary>
${data.answer}
</details>
</div>`;
}

function option(data: PredictData, i: number): Html {
  const words = WORDS[data.lang];
  const { html, right } = data.options[i]!;
  const input = `<input${attributes({ type: "radio", name: data.id, value: String(i) })}>`;
  const verdict = right ? words.rightAnswer : words.wrongAnswer;
  return `<label${attributes({ class: right ? "option right" : "option wrong" })}>${input}<span class="option-text">${html}</span><span class="verdict">${verdict}</span></label>`;
}
