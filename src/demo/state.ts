import type { Words } from "../words/words.ts";
import type { Demo } from "./define.ts";
import type { State } from "./param.ts";

/** A value from outside that was not taken over: which parameter, what was given, what is wrong. */
export interface Problem {
  readonly param: string;
  readonly given: string;
  readonly problem: Words;
}

/** What remains of values from outside once each has been looked at on its own. */
export interface Checked {
  readonly patch: State;
  readonly problems: readonly Problem[];
}

/** The state that the demo's schema declares. */
export function initialState(demo: Demo): State {
  const state: Record<string, unknown> = {};
  for (const [id, param] of Object.entries(demo.params)) state[id] = param.initial;
  return settled(demo, state, state, Object.keys(state));
}

/** The state after a change whose values have been checked. */
export function changed(demo: Demo, state: State, patch: State): State {
  const ids = Object.keys(patch);
  return ids.length === 0 ? state : settled(demo, { ...state, ...patch }, state, ids);
}

function settled(demo: Demo, next: State, previous: State, ids: readonly string[]): State {
  return demo.settle ? demo.settle(next, previous, ids) : next;
}

/** Looks at each value of an object from outside; what is unknown or refused is reported, the rest kept. */
export function checkValues(demo: Demo, values: Readonly<Record<string, unknown>>): Checked {
  return collect(Object.entries(values), (id, given) => demo.params[id]?.accept(given), demo);
}

/** The same for the notation of URLs and attributes. */
export function readValues(demo: Demo, entries: Iterable<readonly [string, string]>): Checked {
  return collect(entries, (id, given) => demo.params[id]?.read(given), demo);
}

type Answer = { ok: true; value: unknown } | { ok: false; problem: Words } | undefined;

function collect<G>(
  entries: Iterable<readonly [string, G]>,
  read: (id: string, given: G) => Answer,
  demo: Demo,
): Checked {
  const patch: Record<string, unknown> = {};
  const problems: Problem[] = [];
  for (const [param, given] of entries) {
    const answer = Object.hasOwn(demo.params, param) ? read(param, given) : undefined;
    if (answer?.ok) patch[param] = answer.value;
    else problems.push({ param, given: shortened(given), problem: answer?.problem ?? unknownParam(demo) });
  }
  return { patch, problems };
}

function unknownParam(demo: Demo): Words {
  const list = Object.keys(demo.params).join(", ");
  return {
    de: `diesen Parameter gibt es hier nicht (es gibt: ${list})`,
    en: `there is no such parameter here (there are: ${list})`,
  };
}

/** Enough of what was given to recognise it. */
function shortened(given: unknown): string {
  const text = typeof given === "string" ? given : (JSON.stringify(given) ?? String(given));
  return text.length > 60 ? `${text.slice(0, 57)}…` : text;
}

/** Whether two states give the same values, as their notation sees it. */
export function sameState(demo: Demo, a: State, b: State): boolean {
  return Object.entries(demo.params).every(
    ([id, param]) => Object.is(a[id], b[id]) || param.write(a[id]) === param.write(b[id]),
  );
}

/** The state on the way from one to another, for gliding. Parameters of different shape jump at the end. */
export function stateBetween(demo: Demo, a: State, b: State, share: number): State {
  const state: Record<string, unknown> = {};
  for (const [id, param] of Object.entries(demo.params)) {
    state[id] = Object.is(a[id], b[id]) ? b[id] : param.between(a[id], b[id], share);
  }
  return state;
}
