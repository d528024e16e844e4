import type { Demo } from "../../demo/index.ts";
import type { State } from "../../demo/param.ts";
import { splitQuery } from "../../demo/query.ts";
import { readValues } from "../../demo/state.ts";
import { choices } from "../problem.ts";

export interface ReadState {
  /** The values that are named, each checked. */
  readonly patch: State;
  /** The same in the notation of URLs, named states written out. */
  readonly query: string;
  readonly problems: readonly { readonly message: string; readonly remedy: string }[];
}

/** Reads what an author writes about a demo's state: `t=0.5&state=half`. */
export function readState(demo: Demo, query: string): ReadState {
  return readEntries(demo, splitQuery(query));
}

/** The same for the attributes of a figure. A parameter that is named counts more than a named state. */
export function readEntries(demo: Demo, entries: Iterable<readonly [string, string]>): ReadState {
  const all = [...entries];
  const problems: { message: string; remedy: string }[] = [];
  let patch: State = {};
  for (const [, name] of all.filter(([id]) => id === "state")) {
    const states = demo.states ?? {};
    if (Object.hasOwn(states, name)) patch = { ...patch, ...states[name] };
    else
      problems.push({
        message: `no state "${name}" of ${demo.id}`,
        remedy: choices(name, Object.keys(states)),
      });
  }
  const params = Object.keys(demo.params);
  const checked = readValues(
    demo,
    all.filter(([id]) => id !== "state"),
  );
  for (const { param, given, problem } of checked.problems) {
    if (params.includes(param)) {
      problems.push({ message: `${param}=${given} cannot be read`, remedy: problem.en });
    } else
      problems.push({ message: `no parameter "${param}" of ${demo.id}`, remedy: choices(param, params) });
  }
  patch = { ...patch, ...checked.patch };
  const text = params
    .filter((id) => Object.hasOwn(patch, id))
    .map((id) => `${id}=${encode(demo.params[id]!.write(patch[id]))}`);
  return { patch, query: text.join("&"), problems };
}

/** As `writeQuery` of the demos does it: separators stay readable. */
function encode(text: string): string {
  return encodeURIComponent(text).replace(/%3B/g, ";").replace(/%2C/g, ",").replace(/%2F/g, "/");
}
