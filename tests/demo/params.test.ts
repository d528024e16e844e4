import { describe, expect, test } from "vitest";
import { handlesOf, withHandles } from "../../src/demo/handles.ts";
import type { Param } from "../../src/demo/param.ts";
import { changed, checkValues, initialState, sameState, stateBetween } from "../../src/demo/state.ts";
import { sample } from "./sample.ts";

const initial = initialState(sample);
const params = Object.entries(sample.params) as [string, Param<unknown>][];

describe.each(params)("parameter %s", (id, param) => {
  const value = initial[id];

  test("its notation reads back", () => {
    expect(param.read(param.write(value))).toEqual({ ok: true, value });
  });

  test("it refuses what is of another kind, with a reason in both languages", () => {
    for (const wrong of [null, undefined, Number.NaN, { x: 1 }, "nonsense", [[1, 2, 3, 4]], 1e9]) {
      const read = param.accept(wrong);
      if (read.ok) throw new Error(`${id} takes ${JSON.stringify(wrong)}`);
      expect(read.problem.de).not.toBe("");
      expect(read.problem.en).not.toBe(read.problem.de);
    }
  });

  test("it rounds to something that it accepts, once and for all", () => {
    const once = param.round(value);
    expect(param.accept(once).ok).toBe(true);
    expect(param.round(once)).toEqual(once);
  });

  test("on the way from a value to itself nothing changes", () => {
    expect(param.between(value, value, 0.3)).toEqual(value);
  });

  test("each field puts a value that the parameter accepts", () => {
    for (const field of param.fields(id, value, { state: initial, views: sample.views })) {
      const next =
        field.kind === "number"
          ? field.put(field.max)
          : field.kind === "boolean"
            ? field.put(!field.value)
            : field.put(field.options[0]!.id);
      expect(param.accept(next).ok, field.id).toBe(true);
    }
  });

  test("each action that is possible gives a value that the parameter accepts", () => {
    for (const action of param.actions(value)) {
      if (action.value !== null) expect(param.accept(action.value).ok, action.id).toBe(true);
    }
  });

  test("each handle, moved far away and nudged, gives a value that the parameter accepts", () => {
    for (const handle of param.handles(id, value, { state: initial, views: sample.views })) {
      for (const to of [[1e6, -1e6], [0.123456789, 0.5], handle.at]) {
        expect(param.accept(handle.put(to)).ok).toBe(true);
      }
      expect(param.accept(handle.nudge([1, 0], 5)).ok).toBe(true);
      expect(handle.nudge([1, 0], 1)).not.toEqual(value);
    }
  });

  test("it says its notation in both languages", () => {
    expect(param.notation().de.length * param.notation().en.length).toBeGreaterThan(0);
  });
});

test("handles are named as the contract says", () => {
  const ids = handlesOf(sample, initial).map((handle) => handle.id);
  expect(ids).toEqual(["points.0", "points.1", "points.2", "m", "patch.0", "patch.1", "patch.2", "patch.3"]);
});

test("a vector's handle sits at its tip, in the drawn scale", () => {
  const tip = handlesOf(sample, {
    ...initial,
    points: [
      [2, 1],
      [3, 3],
    ],
  }).find((handle) => handle.id === "m")!;
  expect(tip.at).toEqual([2.5, 1]);
  expect(tip.put([3, 1.5])).toEqual([2, 1]);
});

test("handles are drawn on top of the scene, with their letters", () => {
  const scene = withHandles({ plane: [] }, handlesOf(sample, initial));
  expect(scene.plane!.map((mark) => mark.key)).toContain("handle-points.1");
  expect(scene.plane!.map((mark) => mark.key)).toContain("letter-points.1");
  expect(scene.plane!.map((mark) => mark.key)).not.toContain("letter-patch.1");
});

test("an arrow key moves a point by a fiftieth of the view", () => {
  const handle = handlesOf(sample, initial).find(({ id }) => id === "points.1")!;
  expect(handle.nudge([1, 0], 1)).toEqual([
    [0, 0],
    [1.1, 2],
    [3, 1],
  ]);
  expect(handle.nudge([0, -1], 5)).toEqual([
    [0, 0],
    [1, 1.5],
    [3, 1],
  ]);
  // A quarter of 0.1 is more than the declared precision of two decimals keeps.
  const quarter = handle.nudge([1, 0], 0.25) as number[][];
  expect(quarter[1]![0]).toBe(1.02);
});

test("settle is applied to every change, and is idempotent", () => {
  const once = changed(sample, initial, { nodes: [2, 0, 1] });
  expect(once.nodes).toEqual([0, 1, 2]);
  expect(changed(sample, once, once)).toEqual(once);
});

test("values from outside are looked at one by one", () => {
  const { patch, problems } = checkValues(sample, {
    t: 0.25,
    n: "3",
    points: [
      [1, 1],
      [2, 2],
    ],
  });
  expect(patch).toEqual({
    t: 0.25,
    points: [
      [1, 1],
      [2, 2],
    ],
  });
  expect(problems.map(({ param, given }) => [param, given])).toEqual([["n", "3"]]);
});

test("half way between two states the numbers are half way, and what cannot glide waits", () => {
  const to = changed(sample, initial, {
    t: 1,
    mode: "b-c",
    points: [
      [0, 2],
      [1, 2],
      [3, 1],
    ],
  });
  const half = stateBetween(sample, initial, to, 0.5);
  expect(half.t).toBe(0.75);
  expect(half.mode).toBe("a");
  expect(half.points).toEqual([
    [0, 1],
    [1, 2],
    [3, 1],
  ]);
  expect(sameState(sample, stateBetween(sample, initial, to, 1), to)).toBe(true);
});
