import { aspect } from "../scene/layout.ts";
import type { Demo } from "./define.ts";
import { initialState } from "./state.ts";

/** Heights of the rows under the picture, in pixels: the main slider with its buttons, and the readout. */
export const ROW = { bar: 52, tools: 48, readout: 40 };

/**
 * The space a figure takes before it is alive, so that nothing moves when it comes to life: the picture's
 * height as a share of the width, and the height of the rows below it, for both layouts.
 */
export interface FigureBox {
  readonly wide: number;
  readonly narrow: number;
  readonly belowWide: number;
  readonly belowNarrow: number;
}

export function figureBox(demo: Demo): FigureBox {
  const state = initialState(demo);
  const readout = demo.readout && demo.readout(state, demo.values(state)).length > 0 ? ROW.readout : 0;
  const slider = Object.values(demo.params).some((param) => param.primary);
  return {
    wide: aspect(demo.views, false),
    narrow: aspect(demo.views, true),
    belowWide: ROW.bar + readout,
    belowNarrow: (slider ? ROW.bar : 0) + ROW.tools + readout,
  };
}
