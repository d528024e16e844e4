import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { figureOf } from "../../src/demo/figure.ts";
import type { Demo } from "../../src/demo/index.ts";
import type { State } from "../../src/demo/param.ts";
import { readQuery, writeQuery } from "../../src/demo/query.ts";
import { changed, initialState } from "../../src/demo/state.ts";
import { demos } from "../../src/demos/index.ts";
import type { Words } from "../../src/words/words.ts";
import { reachableState } from "./random-state.ts";

const RUNS = { numRuns: 60 };
const all = await Promise.all(
  Object.entries(demos).map(async ([id, load]) => [id, (await load()).default] as const),
);

// Surfaces keep samples that have not changed: the same object need not be compared number by number.
expect.addEqualityTesters([
  (a, b) => (typeof a === "object" && a !== null && Object.is(a, b) ? true : undefined),
]);

/** The property holds in every named state and in whatever state a reader can reach. */
function everywhere(demo: Demo, property: (state: State) => void): void {
  property(initialState(demo));
  for (const named of Object.values(demo.states ?? {})) property(changed(demo, initialState(demo), named));
  fc.assert(fc.property(reachableState(demo), property), RUNS);
}

describe.each(all)("demo %s", (id, demo) => {
  test("is named as it is registered", () => {
    expect(demo.id).toBe(id);
  });

  test("is pure: the same state gives the same figure and is left as it was", () => {
    everywhere(demo, (state) => {
      const { handles, ...figure } = figureOf(demo, frozen(structuredClone(state)) as State);
      const { handles: again, ...same } = figureOf(demo, state);
      expect(same).toEqual(figure);
      expect(again.map(({ id, at }) => [id, at])).toEqual(handles.map(({ id, at }) => [id, at]));
    });
  });

  test("draws finite numbers only, each mark under a key of its own, in windows that exist", () => {
    everywhere(demo, (state) => {
      for (const [view, marks] of Object.entries(figureOf(demo, state).scene)) {
        expect(Object.keys(demo.views)).toContain(view);
        const keys = marks.map((mark) => mark.key);
        expect(new Set(keys).size, keys.join(" ")).toBe(keys.length);
        for (const mark of marks) expectFinite(mark, mark.key);
      }
    });
  });

  test("shows something in every window before it is touched", () => {
    const { scene } = figureOf(demo, initialState(demo));
    for (const view of Object.keys(demo.views)) expect(scene[view]?.length ?? 0, view).toBeGreaterThan(0);
  });

  test("computes finite values, or null for what does not exist", () => {
    everywhere(demo, (state) => {
      expectFinite(demo.values(state), "values");
      for (const { value } of figureOf(demo, state).readout) expectFinite(value, "readout");
    });
  });

  test("comes back unchanged from the notation of the URL", () => {
    everywhere(demo, (state) => {
      const base = initialState(demo);
      const { patch, problems } = readQuery(demo, writeQuery(demo, state, base));
      expect(problems).toEqual([]);
      expect(changed(demo, base, patch)).toEqual(state);
    });
  });

  test("settles once and for all", () => {
    everywhere(demo, (state) => {
      const ids = Object.keys(demo.params);
      expect(demo.settle ? demo.settle(state, state, ids) : state).toEqual(state);
    });
  });

  test("speaks both languages", () => {
    const still = [demo.title, ...Object.values(demo.params).map((param) => param.label)];
    for (const words of [...still, ...Object.values(demo.views).map((view) => view.label)]) {
      expect(words.de.trim()).not.toBe("");
      expect(words.en.trim()).not.toBe("");
    }
    everywhere(demo, (state) => expectSpoken(figureOf(demo, state).description));
  });

  test("offers a handle for every point that can be moved, and says what it means to move it", () => {
    everywhere(demo, (state) => {
      const { handles } = figureOf(demo, state);
      expect(new Set(handles.map((handle) => handle.id)).size).toBe(handles.length);
      for (const handle of handles) {
        expect(handle.id).toMatch(new RegExp(`^${handle.param}(\\.\\d+)?$`));
        expect(Object.keys(demo.views)).toContain(handle.view);
        const param = demo.params[handle.param]!;
        expect(param.accept(handle.put(handle.at)).ok).toBe(true);
        expect(param.accept(handle.nudge([1, 0], 5)).ok).toBe(true);
      }
    });
  });
});

test("the handles of the Bézier lesson", () => {
  const count = (id: string) => {
    const demo = all.find(([name]) => name === id)![1];
    return figureOf(demo, initialState(demo)).handles.map((handle) => handle.id);
  };
  expect(count("bezier-curve")).toEqual(["points.0", "points.1", "points.2", "points.3"]);
  expect(count("de-casteljau")).toEqual(["points.0", "points.1", "points.2", "points.3"]);
  expect(count("bernstein-basis")).toEqual(["t"]);
  expect(count("glyph")).toEqual(["outline.1", "outline.2", "outline.3"]);
});

/** Whole sentences in both languages, each with its own decimal sign, and not one text twice. */
function expectSpoken({ de, en }: Words): void {
  expect(de).not.toBe(en);
  for (const text of [de, en]) {
    expect(text).toMatch(/^\p{Lu}.*\.$/su);
    expect(text).not.toMatch(/undefined|null|NaN|Infinity|\[object|-\d/);
  }
  expect(de).not.toMatch(/\d\.\d/);
  expect(en).not.toMatch(/\d,\d/);
}

function expectFinite(value: unknown, where: string): void {
  expect(notFinite(value, where)).toBe(null);
}

/** Where in nested data the first number stands that is not finite. */
function notFinite(value: unknown, where: string): string | null {
  if (typeof value === "number") return Number.isFinite(value) ? null : `${where} = ${value}`;
  if (typeof value !== "object" || value === null) return null;
  for (const [key, entry] of Object.entries(value)) {
    const found = notFinite(entry, `${where}.${key}`);
    if (found) return found;
  }
  return null;
}

/** Throws when anything of the state is written to. */
function frozen(value: unknown): unknown {
  if (typeof value === "object" && value !== null) {
    Object.values(value).forEach(frozen);
    Object.freeze(value);
  }
  return value;
}
