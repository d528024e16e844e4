import fc from "fast-check";
import type { Demo } from "../../src/demo/index.ts";
import type { Param, State, Surroundings } from "../../src/demo/param.ts";
import { changed, initialState } from "../../src/demo/state.ts";

/** Something a reader can do to a figure: turn to a field, press a button, move a handle. */
interface Deed {
  readonly param: number;
  readonly kind: "field" | "action" | "handle";
  readonly which: number;
  /** Two shares from 0 to 1: where in the range, or where in the window. */
  readonly x: number;
  readonly y: number;
}

const share = fc.double({ min: 0, max: 1, noNaN: true });
const deed: fc.Arbitrary<Deed> = fc.record({
  param: fc.nat(99),
  kind: fc.constantFrom("field", "action", "handle"),
  which: fc.nat(999),
  x: share,
  y: share,
});

/** States that a reader can reach by panel, buttons and handles. */
export function reachableState(demo: Demo): fc.Arbitrary<State> {
  return fc
    .array(deed, { maxLength: 25 })
    .map((deeds) => deeds.reduce((state, each) => done(demo, state, each), initialState(demo)));
}

function done(demo: Demo, state: State, { param, kind, which, x, y }: Deed): State {
  const params = Object.entries(demo.params);
  const [id, declared] = params[param % params.length]!;
  const value = newValue(declared, id, state, { demo, kind, which, x, y });
  return value === undefined ? state : changed(demo, state, { [id]: value });
}

function newValue(
  param: Param<unknown>,
  id: string,
  state: State,
  { demo, kind, which, x, y }: Omit<Deed, "param"> & { demo: Demo },
): unknown {
  const value = state[id];
  if (kind === "action") {
    const actions = param.actions(value).filter((action) => action.value !== null);
    return actions[which % actions.length]?.value ?? undefined;
  }
  if (kind === "handle") {
    const around: Surroundings = { state, views: demo.views };
    const handles = param.handles(id, value, around);
    const handle = handles[which % handles.length];
    const view = handle && demo.views[handle.view]!;
    return view && handle.put([between(view.x, x), between(view.y, y)]);
  }
  const fields = param.fields(id, value, { state, views: demo.views });
  const field = fields[which % fields.length];
  if (!field) return undefined;
  if (field.kind === "boolean") return field.put(x < 0.5);
  if (field.kind === "choice")
    return field.put(field.options[Math.floor(x * 0.999 * field.options.length)]!.id);
  const steps = Math.round((field.max - field.min) / field.step);
  return field.put(field.min + Math.round(x * steps) * field.step);
}

function between([from, to]: readonly [number, number], share: number): number {
  return from + (to - from) * share;
}
