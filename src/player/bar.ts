import { decimalsOf } from "../demo/number-text.ts";
import type { Field } from "../demo/param.ts";
import { formatNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { element, icon } from "./element.ts";
import { labelHtml, labelText } from "./label-html.ts";
import { arrowOf, factorOf } from "./shortcuts.ts";

/** The main slider: the parameter that the sentence talks about. */
export interface MainSlider {
  readonly root: HTMLElement;
  update(field: Field<unknown>): void;
}

type NumberField = Extract<Field<unknown>, { kind: "number" }>;

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
      if (next.kind !== "number") return;
      field = next;
      const text = formatNumber(field.value, lang, digits, true);
      range.value = String(field.value);
      range.setAttribute("aria-valuetext", text);
      range.style.setProperty("--share", String((field.value - field.min) / (field.max - field.min || 1)));
      if (shown.textContent !== text) shown.textContent = text;
    },
  };
}

const ICONS = {
  play: "M7 4.5v15l12-7.5z",
  pause: "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",
  undo: "M8.5 5 4 9.5 8.5 14M4.5 9.5H14a5 5 0 0 1 0 10h-4",
  redo: "M15.5 5 20 9.5 15.5 14M19.5 9.5H10a5 5 0 0 0 0 10h4",
  reset: "M5 5v5h5M5.5 10A7.5 7.5 0 1 1 4.6 14",
  fullscreen: "M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5",
  values: "M4 7h9M17 7h3M4 17h3M11 17h9M15 4.5v5M9 14.5v5",
  pencil: "M4 20l1-4L16 5l3 3L8 19zM14 7l3 3",
} as const;

export type ToolId = keyof typeof ICONS;

/** A button of the toolbar, with name and tooltip. */
export interface Tool {
  readonly root: HTMLButtonElement;
  update(options: { name?: string; icon?: ToolId; disabled?: boolean; pressed?: boolean }): void;
}

export function createTool(id: ToolId, name: string, run: () => void): Tool {
  const drawing = icon(ICONS[id]);
  const root = element("button", { type: "button", class: `tool tool-${id}` }, drawing);
  root.addEventListener("click", run);
  const update: Tool["update"] = ({ name: next, icon: picture, disabled, pressed }) => {
    if (next !== undefined) {
      root.title = next;
      root.setAttribute("aria-label", next);
    }
    if (picture) drawing.firstElementChild!.setAttribute("d", ICONS[picture]);
    // A disabled button would lose the focus that has just pressed it.
    if (disabled !== undefined) root.setAttribute("aria-disabled", String(disabled));
    if (pressed !== undefined) root.setAttribute("aria-pressed", String(pressed));
  };
  update({ name });
  return { root, update };
}
