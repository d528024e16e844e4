import type { Scene } from "../scene/marks.ts";
import type { Words } from "../words/words.ts";
import type { Demo, Reading, Values } from "./define.ts";
import { type BoundHandle, handlesOf, withHandles } from "./handles.ts";
import type { State } from "./param.ts";

/** Everything that follows from a demo and a state: what is drawn, grabbed, read and said. */
export interface Figure {
  readonly state: State;
  readonly values: Values;
  readonly handles: readonly BoundHandle[];
  readonly scene: Scene;
  readonly readout: readonly Reading[];
  readonly description: Words;
}

/** The figure of a demo in a state. */
export function figureOf(demo: Demo, state: State): Figure {
  const values = demo.values(state);
  const handles = handlesOf(demo, state);
  return {
    state,
    values,
    handles,
    scene: withHandles(demo.scene(state, values), handles),
    readout: demo.readout?.(state, values) ?? [],
    description: demo.describe(state, values),
  };
}
