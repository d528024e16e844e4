import type { CurveDemo } from "../player/index.ts";
import { formatNumber, parseNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { readHash, show } from "./figure-hash.ts";
import { demoOf } from "./player.ts";

const WORDS = {
  de: {
    hit: "Stimmt.",
    miss: "Stimmt nicht ganz.",
    number: (guess: string, right: string) => `Ihre Zahl: ${guess}. Richtig ist ${right}.`,
    place: (distance: string) => `Ihr Tipp liegt ${distance} Einheiten neben dem Punkt.`,
  },
  en: {
    hit: "Right.",
    miss: "Not quite.",
    number: (guess: string, right: string) => `Your number: ${guess}. Right is ${right}.`,
    place: (distance: string) => `Your guess is ${distance} units away from the point.`,
  },
} as const;

/**
 * A prediction: once there is a guess it can be committed, then the figure goes into the state that answers, and the text
 * says why. Whoever opens the answer without a guess gets the same.
 */
export function prediction(block: HTMLElement, lang: Lang): void {
  const { kind, figure = "", reveal = "", value, place = "", within } = block.dataset;
  const words = WORDS[lang];
  const button = block.querySelector<HTMLButtonElement>(".commit")!;
  const inputs = [...block.querySelectorAll("input")];
  const result = block.querySelector<HTMLElement>(".result")!;
  const answer = block.querySelector<HTMLDetailsElement>("details.answer")!;
  result.tabIndex = -1;
  const answers = figure ? readHash(`#${figure}?${reveal}`) : null;

  const say = (hit: boolean, more: string) => {
    result.textContent = `${hit ? words.hit : words.miss} ${more}`.trim();
  };
  const judgeNumber = () => {
    const guess = parseNumber(inputs[0]!.value)!;
    const write = (x: number) => formatNumber(x, lang, 3);
    say(Math.abs(guess - Number(value)) <= Number(within), words.number(write(guess), write(Number(value))));
  };
  /** Compares once the figure has arrived in the state that answers. */
  const judgePlace = (demo: CurveDemo) => {
    const [guess] = demo.state.guess as readonly (readonly number[])[];
    const arrived = (event: Event) => {
      if (!(event as CustomEvent<{ committed: boolean }>).detail.committed) return;
      demo.removeEventListener("statechange", arrived);
      const at = demo.values[place] as readonly number[];
      const distance = Math.hypot(...at.map((x, k) => x - guess![k]!));
      say(distance <= Number(within), words.place(formatNumber(distance, lang)));
    };
    demo.addEventListener("statechange", arrived);
  };

  const ready = () => {
    button.disabled =
      kind === "number" ? parseNumber(inputs[0]!.value) === null : !inputs.some((input) => input.checked);
  };
  block.addEventListener("input", ready);
  if (kind === "place") {
    answers?.figure.addEventListener("statechange", ({ target }) => {
      // A guess is made as soon as the mark is not where it began.
      if (/(^|&)guess=/.test((target as CurveDemo).query)) button.disabled = false;
    });
  } else ready();

  block.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && event.target === inputs[0] && kind === "number" && !button.disabled)
      button.click();
  });
  button.addEventListener("click", async () => {
    if (kind === "choice") say(block.querySelector(".right :checked") !== null, "");
    if (kind === "number") judgeNumber();
    if (kind === "place" && answers) judgePlace((await demoOf(answers.figure))!);
    for (const input of inputs) input.disabled = true;
    block.classList.add("is-committed");
    answer.open = true;
    // The button goes; the focus must not fall out of the page. Not onto the summary: the key that was pressed here would
    // close it at once.
    result.focus({ preventScroll: true });
  });
  answer.addEventListener("toggle", () => {
    if (answer.open && answers) void show(answers);
  });
}
