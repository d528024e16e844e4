import type { Demo } from "../demo/define.ts";
import type { State } from "../demo/param.ts";
import { changed, sameState } from "../demo/state.ts";

export type Source = "user" | "program";

/** What happened to the state, for those who listen. */
export interface Change {
  readonly state: State;
  readonly source: Source;
  /** Whether this is a step that undo takes back, or still on the way there. */
  readonly committed: boolean;
}

export interface Step {
  readonly source: Source;
  /** Default true. A drag in progress is not committed. */
  readonly commit?: boolean;
  /** Steps of the same kind that follow each other closely are one step for undo: repeated key presses. */
  readonly merge?: { readonly kind: string; readonly time: number };
}

/** The state of one figure with its history. */
export interface Store {
  readonly state: State;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Takes over checked values. */
  set(patch: State, step: Step): void;
  /** Forgets what has not been committed. */
  cancel(): void;
  undo(): void;
  redo(): void;
  /** Back to the given state, as a step of its own. */
  reset(to: State): void;
  listen(listener: (change: Change) => void): void;
}

const MERGE_WITHIN = 900;
const MAX_HISTORY = 200;

export function createStore(demo: Demo, initial: State): Store {
  let state = initial;
  let committed = initial;
  let past: State[] = [];
  let future: State[] = [];
  let last: Step["merge"];
  const listeners: ((change: Change) => void)[] = [];

  const tell = (source: Source, isCommitted: boolean) => {
    for (const listener of listeners) listener({ state, source, committed: isCommitted });
  };
  const commit = (merge: Step["merge"]) => {
    const follows = merge && last && merge.kind === last.kind && merge.time - last.time < MERGE_WITHIN;
    if (!sameState(demo, state, committed)) {
      if (!follows) past = [...past, committed].slice(-MAX_HISTORY);
      future = [];
    }
    committed = state;
    last = merge;
  };
  const travel = (from: State[], to: State[]) => {
    const next = from.pop();
    if (!next) return;
    to.push(committed);
    state = committed = next;
    last = undefined;
    tell("user", true);
  };

  return {
    get state() {
      return state;
    },
    get canUndo() {
      return past.length > 0;
    },
    get canRedo() {
      return future.length > 0;
    },
    set(patch, step) {
      state = changed(demo, state, patch);
      const isCommitted = step.commit !== false;
      if (isCommitted) commit(step.merge);
      tell(step.source, isCommitted);
    },
    cancel() {
      if (state === committed) return;
      state = committed;
      tell("user", true);
    },
    undo: () => travel(past, future),
    redo: () => travel(future, past),
    reset(to) {
      state = to;
      commit(undefined);
      tell("user", true);
    },
    listen: (listener) => listeners.push(listener),
  };
}
