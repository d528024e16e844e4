import type { Demo } from "../demo/define.ts";
import { type Figure, figureOf } from "../demo/figure.ts";
import type { State } from "../demo/param.ts";
import type { FrameOptions } from "./frame.ts";
import { createMover, type Mover } from "./mover.ts";
import { createStore, type Store } from "./store.ts";

/** What all parts of a living figure share. */
export interface Core {
  readonly demo: Demo;
  readonly options: FrameOptions;
  readonly embedded: boolean;
  readonly store: Store;
  readonly mover: Mover;
  /** The figure of the present state, computed when somebody asks. */
  readonly figure: Figure;
  /** The figure's own initial state, to which reset goes back. */
  own(): State;
  /** Asks for a drawing in the next frame. */
  request(): void;
}

export function createCore(
  demo: Demo,
  initial: State,
  options: FrameOptions,
  frame: { readonly embedded: boolean; own(): State; request(): void },
): Core {
  const store = createStore(demo, initial);
  let figure = figureOf(demo, initial);
  return {
    demo,
    options,
    embedded: frame.embedded,
    store,
    mover: createMover(demo, store, frame.request),
    get figure() {
      if (figure.state !== store.state) figure = figureOf(demo, store.state);
      return figure;
    },
    own: frame.own,
    request: frame.request,
  };
}
