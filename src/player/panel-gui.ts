import { BooleanController, Controller, GUI, OptionController } from "lil-gui";
import type { Field } from "../demo/param.ts";
import { formatNumber, parseNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";
import { labelText } from "./label-html.ts";

/** A field together with the parameter it changes. */
export interface BoundField {
  readonly param: string;
  readonly field: Field<unknown>;
}

/** What the panel asks of the player: take this value for that field, for good or still moving. */
export type PutField = (id: string, value: number | boolean | string, commit: boolean) => void;

export interface Gui {
  update(fields: readonly BoundField[]): void;
  destroy(): void;
}

/** Decimals shown for a step, two at least, so that a dragged point is shown as it is. */
const digitsOf = (step: number) => Math.max(2, Math.ceil(-Math.log10(step)));

/**
 * The lil-gui panel for a list of fields. It never changes our state: its model is a plain object of its
 * own, its answers go through `put`, and what it shows comes from `update`.
 */
export function createGui(
  container: HTMLElement,
  fields: readonly BoundField[],
  lang: Lang,
  put: PutField,
): Gui {
  const gui = new GUI({ container, injectStyles: false, title: "" });
  // Sizes come from our own sheet, on every kind of pointer.
  gui.domElement.classList.remove("lil-allow-touch-styles");
  gui.$title.remove();
  gui.domElement.addEventListener("wheel", (event) => event.stopPropagation(), { capture: true });
  const model: Record<string, number | boolean | string> = {};
  const controllers = new Map<string, Controller>();
  const groups = new Map<string, GUI>();
  for (const { field } of fields) {
    model[field.id] = field.value;
    const group = field.kind === "number" && field.group ? labelText(field.group, lang) : null;
    const name = labelText(field.label, lang);
    const parent = group === null ? gui : (groups.get(group) ?? gui.addFolder(group));
    if (group !== null) groups.set(group, parent);
    const controller = addController(parent, model, field, lang, group ? `${group} ${name}` : name);
    controller.name(name);
    controller.onChange((value: number | boolean | string) => put(field.id, value, field.kind !== "number"));
    controller.onFinishChange((value: number | boolean | string) => put(field.id, value, true));
    controllers.set(field.id, controller);
  }
  return {
    update(next) {
      for (const { field } of next) {
        if (Object.is(model[field.id], field.value)) continue;
        model[field.id] = field.value;
        controllers.get(field.id)?.updateDisplay();
      }
    },
    destroy: () => gui.destroy(),
  };
}

function addController(
  parent: GUI,
  model: Record<string, number | boolean | string>,
  field: Field<unknown>,
  lang: Lang,
  name: string,
): Controller {
  switch (field.kind) {
    case "number":
      return new NumberField(parent, model, field, lang, name);
    case "boolean":
      return new BooleanController(parent, model, field.id);
    case "choice":
      return new OptionController(
        parent,
        model,
        field.id,
        Object.fromEntries(field.options.map((option) => [option.label[lang], option.id])),
      );
  }
}

/**
 * A number with a native slider and a text field that reads comma and point. (The library's own number
 * controller reads "0,5" as 0 and its slider has no keyboard.)
 */
class NumberField extends Controller {
  readonly #range = element("input", { type: "range" });
  readonly #text = element("input", { type: "text", inputmode: "decimal", autocomplete: "off" });
  readonly #lang: Lang;
  readonly #digits: number;

  constructor(
    parent: GUI,
    model: Record<string, unknown>,
    field: Extract<Field<unknown>, { kind: "number" }>,
    lang: Lang,
    name: string,
  ) {
    super(parent, model, field.id, "lil-number");
    this.#lang = lang;
    this.#digits = Number.isInteger(field.step) ? 0 : digitsOf(field.step);
    this.#range.min = String(field.min);
    this.#range.max = String(field.max);
    this.#range.step = String(field.step);
    this.#text.setAttribute("aria-label", name);
    this.#range.setAttribute("aria-label", name);
    // One tab stop a number: the text field takes typed values and arrow keys, the slider the pointer.
    this.#range.tabIndex = -1;
    this.#range.addEventListener("input", () => this.setValue(Number(this.#range.value)));
    this.#range.addEventListener("change", () => this._callOnFinishChange());
    this.#text.addEventListener("change", () => this.#take());
    this.#text.addEventListener("keydown", (event) => this.#key(event, field.step, field.min, field.max));
    this.$widget.append(this.#range, this.#text);
    this.updateDisplay();
  }

  #take(): void {
    const value = parseNumber(this.#text.value);
    const fits = value !== null && value >= Number(this.#range.min) && value <= Number(this.#range.max);
    this.#text.toggleAttribute("aria-invalid", !fits);
    if (!fits) return;
    this.setValue(value);
    this._callOnFinishChange();
    this.updateDisplay();
  }

  #key(event: KeyboardEvent, step: number, min: number, max: number): void {
    if (event.key === "Enter") this.#take();
    const sign = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (sign === 0) return;
    event.preventDefault();
    const next = Number(this.getValue()) + sign * step * (event.shiftKey ? 5 : 1);
    this.setValue(Math.min(max, Math.max(min, Number(next.toFixed(10)))));
    this._callOnFinishChange();
  }

  override updateDisplay(): this {
    const value = Number(this.getValue());
    this.#range.value = String(value);
    this.#text.value = formatNumber(value, this.#lang, this.#digits);
    this.#text.removeAttribute("aria-invalid");
    return this;
  }
}
