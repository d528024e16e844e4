import type { Reading } from "../demo/define.ts";
import { formatNumber, formatPoint } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";
import { labelHtml, labelText } from "./label-html.ts";

export interface Readout {
  readonly root: HTMLElement;
  update(readings: readonly Reading[]): void;
}

/** The line of live numbers under the picture: symbol = value, in figures of equal width. */
export function createReadout(lang: Lang, name: string): Readout {
  const root = element("div", { class: "readout", role: "group", "aria-label": name, tabindex: "-1" });
  let shape = "";
  let cells: HTMLElement[] = [];
  return {
    root,
    update(readings) {
      const now = readings.map((reading) => labelText(reading.label, lang)).join("|");
      if (now !== shape) {
        shape = now;
        cells = readings.map(() => element("span", { class: "number" }));
        root.replaceChildren(...readings.map((reading, i) => entry(reading, cells[i]!, lang)));
      }
      readings.forEach((reading, i) => {
        const text = valueText(reading, lang);
        if (cells[i]!.textContent !== text) cells[i]!.textContent = text;
        // Room for the longest value so far, so that the line does not jump.
        const room = Math.max(text.length, Number.parseInt(cells[i]!.dataset.room ?? "0", 10));
        if (cells[i]!.dataset.room !== String(room)) {
          cells[i]!.dataset.room = String(room);
          cells[i]!.style.minWidth = `${room * 0.92}ch`;
        }
      });
    },
  };
}

function entry(reading: Reading, cell: HTMLElement, lang: Lang): HTMLElement {
  const index = reading.index === undefined ? "" : `index-${reading.index % 10}`;
  return element("span", { class: `reading ${index}` }, labelHtml(reading.label, lang), " = ", cell);
}

/** A value as the readout shows it; what does not exist is a dash. */
export function valueText({ value, digits = 2 }: Reading, lang: Lang): string {
  if (value === null) return "–";
  return typeof value === "number"
    ? formatNumber(value, lang, digits, true)
    : formatPoint(value, lang, digits, true);
}
