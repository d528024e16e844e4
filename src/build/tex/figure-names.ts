import { handlesOf } from "../../demo/handles.ts";
import type { Demo, Value } from "../../demo/index.ts";
import type { Param, State } from "../../demo/param.ts";
import { changed } from "../../demo/state.ts";

/** What a name of a figure means to a formula. */
export interface NamedThing {
  readonly index?: number;
  /** Whether something of the figure can light up: a mark, a handle, a slider. A computed value alone cannot. */
  readonly seen: boolean;
}

export interface FigureNames {
  readonly names: ReadonlyMap<string, NamedThing>;
  /** A named value or parameter in the figure's own state; undefined where there is none. */
  value(path: string): unknown;
}

/**
 * All names to which a formula may tie a symbol: marks and handles in the figure's own state, in the demo's named states
 * and in the states that the text leads to; parameters; computed values and their entries.
 */
export function figureNames(demo: Demo, own: State, patches: readonly State[]): FigureNames {
  const known = made.get(demo) ?? new Map<string, FigureNames>();
  made.set(demo, known);
  const key = JSON.stringify([own, patches]);
  const names = known.get(key) ?? gather(demo, own, patches);
  known.set(key, names);
  return names;
}

/** The names of figures seen so far: both languages of a lesson have the same ones. */
const made = new WeakMap<Demo, Map<string, FigureNames>>();

function gather(demo: Demo, own: State, patches: readonly State[]): FigureNames {
  const names = new Map<string, NamedThing>();
  const add = (name: string, thing: NamedThing) => {
    const before = names.get(name);
    const index = before?.index ?? thing.index;
    names.set(name, { seen: thing.seen || before?.seen === true, ...(index === undefined ? {} : { index }) });
  };
  const states = [
    own,
    ...[...Object.values(demo.states ?? {}), ...patches].map((p) => changed(demo, own, p as State)),
  ];
  for (const state of states) {
    const values = demo.values(state);
    for (const mark of Object.values(demo.scene(state, values)).flat()) {
      if (mark.name !== undefined) add(mark.name, { seen: true, ...indexOf(mark) });
    }
    for (const handle of handlesOf(demo, state)) add(handle.id, { seen: true, ...indexOf(handle) });
    addValues(values, "", 3, add);
    addValues(state as Readonly<Record<string, Value>>, "", 3, add);
  }
  for (const [id, param] of Object.entries(demo.params) as [string, Param<unknown>][]) {
    if (param.primary) add(id, { seen: true });
  }
  const values = { ...own, ...demo.values(own) };
  return { names, value: (path) => valueAt(values, path) };
}

function indexOf(thing: { readonly index?: number }): { index?: number } {
  return thing.index === undefined ? {} : { index: thing.index };
}

function addValues(
  values: object,
  before: string,
  depth: number,
  add: (name: string, thing: NamedThing) => void,
): void {
  for (const [key, value] of Object.entries(values)) {
    add(before + key, { seen: false });
    if (depth > 0 && Array.isArray(value)) addValues(value, `${before}${key}.`, depth - 1, add);
  }
}

/** Follows a path like `levels.1.0`. */
function valueAt(values: unknown, path: string): unknown {
  return path
    .split(".")
    .reduce<unknown>((found, key) => (found as Record<string, unknown> | null | undefined)?.[key], values);
}
