import { type Label, symbol } from "../../scene/label.ts";
import type { XY } from "../../scene/marks.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { clamp, decimalsOf, isNumberIn, readNumber, roundTo, writeNumber } from "../number-text.ts";
import { bad, good, type Handle, type Param, type State } from "../param.ts";

export interface NumberOptions {
  readonly initial: number;
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly label: Words;
  /** The symbol of the formulas, if the number has one. Default: the label's words. */
  readonly symbol?: Label;
  /** Only whole multiples of the step count from `min` on, everywhere: degrees, counts. */
  readonly whole?: boolean;
  /** Play moves this number from min to max in so many seconds. */
  readonly animate?: number;
  readonly primary?: boolean;
  /** A handle in a view: where it is in a state, and what number a point means. */
  readonly handle?: {
    readonly view: string;
    readonly at: (state: State) => XY;
    readonly from: (point: XY, state: State) => number;
  };
}

/** A number in an interval. */
export function number(options: NumberOptions): Param<number> {
  const { initial, min, max, step, label, whole } = options;
  const decimals = decimalsOf(step);
  const name: Label = options.symbol ?? { base: label, style: "text" };
  const fits = (value: unknown): value is number =>
    isNumberIn(value, min, max) && (!whole || Number.isInteger(value));
  const range = (lang: "de" | "en") => `${formatNumber(min, lang, 6)} … ${formatNumber(max, lang, 6)}`;
  const refuse = <T>() =>
    whole
      ? bad<T>(
          `erwartet wird eine ganze Zahl im Bereich ${range("de")}`,
          `expected a whole number in ${range("en")}`,
        )
      : bad<T>(`erwartet wird eine Zahl im Bereich ${range("de")}`, `expected a number in ${range("en")}`);
  const near = (value: number) => clamp(roundTo(value, decimals), min, max);
  return {
    type: "number",
    label,
    initial,
    ...(options.animate ? { animate: { from: min, to: max, seconds: options.animate } } : {}),
    ...(options.primary ? { primary: true } : {}),
    read: (text) => {
      const value = readNumber(text);
      return fits(value) ? good(value) : refuse();
    },
    write: writeNumber,
    accept: (value) => (fits(value) ? good(value) : refuse()),
    round: near,
    between: (a, b, share) => (whole ? (share < 1 ? a : b) : a + (b - a) * share),
    handles: (id, value, { state }): Handle<number>[] => {
      const { handle } = options;
      if (!handle) return [];
      return [
        {
          id,
          view: handle.view,
          at: handle.at(state),
          label: name,
          put: (to) => near(handle.from(to, state)),
          nudge: ([dx, dy], factor) => near(value + (dx! + dy!) * factor * Math.max(step, (max - min) / 50)),
        },
      ];
    },
    fields: (id, value) => [
      { kind: "number", id, label: name, value, min, max, step, put: (next) => clamp(next, min, max) },
    ],
    actions: () => [],
    notation: () =>
      inBoth(
        (lang) =>
          `${whole ? (lang === "de" ? "ganze Zahl" : "whole number") : lang === "de" ? "Zahl" : "number"}, ${range(lang)}`,
      ),
  };
}

/** The usual curve parameter: t in [0, 1], moved by play. */
export function parameterT(options: Partial<NumberOptions> = {}): Param<number> {
  return number({
    initial: 0.5,
    min: 0,
    max: 1,
    step: 0.01,
    label: { de: "Parameter t", en: "Parameter t" },
    symbol: symbol("t"),
    animate: 5,
    primary: true,
    ...options,
  });
}
