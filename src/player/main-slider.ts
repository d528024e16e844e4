import { decimalsOf } from "../demo/number-text.ts";
import type { Field } from "../demo/param.ts";
import { formatNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";
import { labelHtml, labelText } from "./label-html.ts";
import { arrowOf, factorOf } from "./shortcuts.ts";

/** The main slider: the parameter that the sentence talks about. */
export interface MainSlider {
  readonly root: HTMLElement;
  update(field: NumberField): void;
}

/** The panel's entry of a number. */
export type NumberField = Extract<Field<unknown>, { kind: "number" }>;

export function createMainSlider(
  first: NumberField,
  lang: Lang,
  embedded: boolean,
  put: (value: number, commit: boolean, event: Event) => void,
): MainSlider {
  const range = element("input", { type: "range", "aria-label": labelText(first.label, lang) });
  const shown = element("output", { class: "number" });
  const digits = decimalsOf(first.step);
  let field = first;
  range.min = String(first.min);
  range.max = String(first.max);
  range.step = String(first.step);
  const take = (commit: boolean, event: Event) => put(Number(range.value), commit, event);
  range.addEventListener("input", (event) => take(false, event));
  range.addEventListener("change", (event) => take(true, event));
  range.addEventListener("keydown", (event) => {
    // In a slide deck the page keys belong to the deck.
    if (embedded && event.key.startsWith("Page")) return event.preventDefault();
    const arrow = arrowOf(event);
    if (!arrow) return;
    event.preventDefault();
    const stride = Math.max(field.step, Math.abs((field.max - field.min) / 50) * factorOf(event));
    const steps = Math.max(1, Math.round(stride / field.step));
    const next = field.value + (arrow[0] + arrow[1]) * steps * field.step;
    put(Math.min(field.max, Math.max(field.min, Number(next.toFixed(digits)))), true, event);
  });
  const root = element("label", { class: "main-slider" }, labelHtml(first.label, lang), range, shown);
  return {
    root,
    update(next) {
      field = next;
      const text = formatNumber(field.value, lang, digits, true);
      range.value = String(field.value);
      range.setAttribute("aria-valuetext", text);
      range.style.setProperty("--share", String((field.value - field.min) / (field.max - field.min || 1)));
      if (shown.textContent !== text) shown.textContent = text;
    },
  };
}
