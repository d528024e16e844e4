import type { Demo } from "../demo/define.ts";
import type { Param, State } from "../demo/param.ts";
import { stateBetween } from "../demo/state.ts";
import { createAnimation } from "./animation.ts";
import { reducedMotion } from "./frame.ts";
import type { Source, Step, Store } from "./store.ts";

/** All the ways in which the state of a figure is changed end here. */
export interface Mover {
  readonly moving: boolean;
  /** Whether there is a parameter that play moves. */
  readonly canPlay: boolean;
  /** A value from the reader's hand: handle, slider, panel, pencil. */
  put(id: string, value: unknown, commit: boolean, merge?: Step["merge"]): void;
  /** Checked values from a link, a message or a program; glides there if asked and allowed. */
  go(patch: State, options: { source: Source; glide?: boolean; commit?: boolean }): void;
  /** Goes on by itself for a while, as a turned figure does that is let go. */
  coast(seconds: number, at: (share: number) => State): void;
  play(on: boolean): void;
  /** Whatever moves by itself stops where it is. */
  stop(): void;
  /** A step through the history. */
  travel(step: () => void): void;
  hold(held: boolean): void;
  destroy(): void;
}

/** Seconds that a link in the text takes to glide into its state. */
const GLIDE = 0.3;

export function createMover(demo: Demo, store: Store, request: () => void): Mover {
  const animation = createAnimation();
  const animated = (Object.entries(demo.params) as [string, Param<unknown>][]).find(
    ([, param]) => param.animate,
  );

  /** Whatever moves by itself gives way to the reader's hand; where it stopped is a step of its own. */
  const stop = () => {
    if (!animation.running) return;
    animation.stop();
    store.set({}, { source: "user" });
  };
  return {
    get moving() {
      return animation.running;
    },
    canPlay: animated !== undefined,
    put(id, value, commit, merge) {
      stop();
      store.set({ [id]: value }, { source: "user", commit, ...(merge ? { merge } : {}) });
    },
    go(patch, { source, glide, commit }) {
      stop();
      if (!glide || reducedMotion()) return store.set(patch, { source, commit: commit !== false });
      const from = store.state;
      const to = { ...from, ...patch };
      const step = (share: number) => {
        const eased = share * share * (3 - 2 * share);
        const there = share === 1;
        store.set(there ? patch : stateBetween(demo, from, to, eased), {
          source,
          commit: there && commit !== false,
        });
      };
      animation.start(GLIDE, step, request);
    },
    coast(seconds, at) {
      const step = (share: number) => store.set(at(share), { source: "user", commit: share === 1 });
      animation.start(seconds, step, request);
    },
    play(on) {
      if (!on) return stop();
      if (!animated) return;
      const [id, param] = animated;
      const { from, to, seconds } = param.animate!;
      const now = store.state[id] as number;
      const start = now >= to ? from : now;
      const step = (share: number) =>
        store.set({ [id]: start + (to - start) * share }, { source: "user", commit: false });
      animation.start((seconds * (to - start)) / (to - from), step, () => store.set({}, { source: "user" }));
      request();
    },
    stop,
    travel(step) {
      stop();
      step();
    },
    hold: (held) => animation.hold(held),
    destroy: () => animation.stop(),
  };
}
