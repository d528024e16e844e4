import type { Label } from "../../scene/label.ts";
import { symbol } from "../../scene/label.ts";
import type { XY } from "../../scene/marks.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { areRows, place, readRows, replaced, writeRows } from "../coordinates.ts";
import { bad, type Field, good, type Param, type State } from "../param.ts";

export interface VectorOptions {
  readonly initial: XY;
  readonly label: Words;
  readonly symbol: Label;
  /** The point at which the vector is attached; its handle sits at the tip. */
  readonly anchor: (state: State) => XY;
  /** Drawn length per unit: long derivatives are drawn shorter. Default 1. */
  readonly scale?: number;
  readonly view?: string;
  readonly index?: number;
  /** Largest modulus of a component. Default 20. */
  readonly reach?: number;
  readonly precision?: number;
}

/** A vector of the plane, moved by its tip. */
export function vector(options: VectorOptions): Param<XY> {
  const {
    initial,
    label,
    symbol: name,
    anchor,
    scale = 1,
    view = "plane",
    reach = 20,
    precision = 2,
  } = options;
  const ranges = [
    [-reach, reach],
    [-reach, reach],
  ] as const;
  const refuse = () =>
    bad<XY>(
      `erwartet wird ein Vektor x,y mit Beträgen bis ${formatNumber(reach, "de")}`,
      `expected a vector x,y with components up to ${formatNumber(reach, "en")}`,
    );
  const check = (value: unknown) =>
    areRows([value], 2, ranges) ? good<XY>([...(value as readonly number[])]) : refuse();
  const step = 10 ** -precision;
  return {
    type: "vector",
    label,
    initial,
    read: (text) => {
      const rows = readRows(text);
      return rows?.length === 1 ? check(rows[0]) : refuse();
    },
    write: (value) => writeRows([value]),
    accept: check,
    round: (value) => place(value, ranges, precision),
    between: (a, b, share) => a.map((x, k) => x + (b[k]! - x) * share),
    handles: (id, value, { state, views }) => {
      const foot = anchor(state);
      const put = (to: XY) =>
        place([(to[0]! - foot[0]!) / scale, (to[1]! - foot[1]!) / scale], ranges, precision);
      const at = [foot[0]! + value[0]! * scale, foot[1]! + value[1]! * scale];
      const window = views[view];
      const stride = window
        ? [(window.x[1] - window.x[0]) / 50, (window.y[1] - window.y[0]) / 50]
        : [0.1, 0.1];
      return [
        {
          id,
          view,
          at,
          label: name,
          lettered: true,
          ...(options.index === undefined ? {} : { index: options.index }),
          put,
          nudge: ([dx, dy], factor) =>
            place(
              [0, 1].map((k) => value[k]! + [dx, dy][k]! * Math.max(step, (stride[k]! * factor) / scale)),
              ranges,
              precision,
            ),
        },
      ];
    },
    fields: (id, value) =>
      (["x", "y"] as const).map(
        (axis, k): Field<XY> => ({
          kind: "number",
          id: `${id}.${axis}`,
          group: name,
          label: symbol(axis),
          value: value[k]!,
          min: -reach,
          max: reach,
          step,
          put: (next) => place(replaced(value, k, next), ranges, 12),
        }),
      ),
    actions: () => [],
    notation: () => inBoth((lang) => `x,y (|x|, |y| ≤ ${formatNumber(reach, lang)})`),
  };
}
