import type { Camera } from "../scene/camera.ts";
import type { Views } from "../scene/layout.ts";
import type { Scene } from "../scene/marks.ts";
import type { Words } from "../words/words.ts";
import type { Demo, Reading, Values } from "./define.ts";
import { describeCamera } from "./describe-camera.ts";
import { type BoundHandle, handlesOf, withHandles } from "./handles.ts";
import type { State } from "./param.ts";

/** Everything that follows from a demo and a state: what is drawn, grabbed, read and said. */
export interface Figure {
  readonly state: State;
  readonly values: Values;
  /** The demo's windows; those into space with the camera of the state. */
  readonly views: Views;
  readonly handles: readonly BoundHandle[];
  readonly scene: Scene;
  readonly readout: readonly Reading[];
  readonly description: Words;
}

/** The figure of a demo in a state. */
export function figureOf(demo: Demo, state: State): Figure {
  const values = demo.values(state);
  const views = viewsIn(demo, state);
  const handles = handlesOf(demo, state, views);
  return {
    state,
    values,
    views,
    handles,
    scene: withHandles(demo.scene(state, values), handles),
    readout: demo.readout?.(state, values) ?? [],
    // Only when somebody listens: a drag has no time for sentences.
    get description() {
      const said = demo.describe(state, values);
      return views === demo.views ? said : describeCamera(said, state.camera as Camera);
    },
  };
}

function viewsIn(demo: Demo, state: State): Views {
  const camera = state.camera as Camera | undefined;
  if (!camera || !demo.params.camera) return demo.views;
  return Object.fromEntries(
    Object.entries(demo.views).map(([id, view]) => [
      id,
      view.space ? { ...view, space: { ...view.space, camera } } : view,
    ]),
  );
}
