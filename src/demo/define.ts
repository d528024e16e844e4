import type { Camera, FlatView } from "../scene/camera.ts";
import type { Label } from "../scene/label.ts";
import type { Views } from "../scene/layout.ts";
import type { Scene } from "../scene/marks.ts";
import type { Words } from "../words/words.ts";
import type { Params, State, StateOf } from "./param.ts";
import { camera } from "./params/camera.ts";

/** What a figure computes: numbers, points, lists, matrices; null for what does not exist. */
export type Value = number | boolean | string | null | readonly Value[];
export type Values = Readonly<Record<string, Value>>;

/** One entry of the readout under the picture: symbol = value. */
export interface Reading {
  readonly label: Label;
  readonly value: number | readonly number[] | null;
  /** Decimals shown, always so many, so that the line does not jump. Default 2. */
  readonly digits?: number;
  /** The entry of the index palette that the symbol carries. */
  readonly index?: number;
}

/** What the author of a demo writes: everything else is derived from it. */
export interface DemoSpec<P extends Params, V extends Values> {
  readonly id: string;
  readonly title: Words;
  readonly params: P;
  /** The windows of the figure, linked by the one state. */
  readonly views: Views;
  /** Keeps a state admissible (nodes in order, a partner moved along). Pure and idempotent. */
  settle?(next: StateOf<P>, previous: StateOf<P>, changed: readonly string[]): StateOf<P>;
  /** Named results, for readouts, tied formulas and tests. */
  values(state: StateOf<P>): V;
  /** The marks of each view, in painting order; handles are added by themselves. */
  scene(state: StateOf<P>, values: V): Scene;
  readout?(state: StateOf<P>, values: V): readonly Reading[];
  /** What is to be seen, in words, for those who cannot see it. */
  describe(state: StateOf<P>, values: V): Words;
  /** Named states, for links in the text, lecture mode and tests; with a camera, where space is looked into. */
  readonly states?: Readonly<Record<string, Partial<StateOf<P>> & { readonly camera?: Camera | FlatView }>>;
}

/** A demo with its types forgotten, as player and build see it. */
export interface Demo extends DemoSpec<Params, Values> {}

const RESERVED = new Set(
  "demo lang theme controls autoplay still dpr camera state seed solutions tries id class style slot title hidden".split(
    " ",
  ),
);

/**
 * Declares a demo.
 *
 * @throws RangeError if an id is not of the form `[a-z][a-z0-9-]*` or a reserved name, if a named state
 *   names an unknown parameter or holds a value that its parameter refuses.
 *
 * A demo that looks into space has its camera as one more parameter, so that address, undo, links and messages know it.
 */
export function defineDemo<const P extends Params, V extends Values>(spec: DemoSpec<P, V>): Demo {
  // Methods are checked bivariantly, so the erased type is sound as long as states come from these params.
  const demo = withCamera(spec as unknown as Demo);
  for (const id of [spec.id, ...Object.keys(spec.params)]) {
    if (!/^[a-z][a-z0-9-]*$/.test(id))
      throw new RangeError(`demo ${spec.id}: id "${id}" must match [a-z][a-z0-9-]*`);
  }
  for (const [id, param] of Object.entries(spec.params)) {
    if (RESERVED.has(id) && Object.hasOwn(spec.params, id))
      throw new RangeError(`demo ${spec.id}: the parameter name "${id}" is reserved`);
    const read = param.accept(param.initial);
    if (!read.ok) throw new RangeError(`demo ${spec.id}: initial value of "${id}": ${read.problem.en}`);
  }
  if (!demo.states) return demo;
  const named = Object.entries(demo.states).map(([name, state]) => [name, checkedState(demo, name, state)]);
  return { ...demo, states: Object.fromEntries(named) as Record<string, State> };
}

function withCamera(demo: Demo): Demo {
  const window = Object.values(demo.views).find((view) => view.space)?.space;
  return window ? { ...demo, params: { ...demo.params, camera: camera(window.camera) } } : demo;
}

/** A named state in the values that its parameters make of it. */
function checkedState(demo: Demo, name: string, state: State): State {
  const checked: Record<string, unknown> = {};
  for (const [id, value] of Object.entries(state)) {
    const read = demo.params[id]?.accept(value);
    if (!read) throw new RangeError(`demo ${demo.id}: state "${name}" names the unknown parameter "${id}"`);
    if (!read.ok) throw new RangeError(`demo ${demo.id}: state "${name}": ${id}: ${read.problem.en}`);
    checked[id] = read.value;
  }
  return checked;
}
