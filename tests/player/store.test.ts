import { expect, test } from "vitest";
import { changed, initialState } from "../../src/demo/state.ts";
import { createStore } from "../../src/player/store.ts";
import { sample } from "../demo/sample.ts";

const fresh = () => createStore(sample, initialState(sample));
const user = { source: "user" } as const;

test("undo takes back a committed step, redo brings it again", () => {
  const store = fresh();
  store.set({ t: 0.7 }, user);
  store.set({ t: 0.9 }, { source: "program" });
  store.undo();
  expect(store.state.t).toBe(0.7);
  store.undo();
  expect(store.state.t).toBe(0.5);
  expect(store.canUndo).toBe(false);
  store.redo();
  expect(store.state.t).toBe(0.7);
  store.set({ t: 0.1 }, user);
  expect(store.canRedo).toBe(false);
});

test("a drag is one step, however many moves it has", () => {
  const store = fresh();
  for (const t of [0.6, 0.7, 0.8]) store.set({ t }, { ...user, commit: false });
  expect(store.canUndo).toBe(false);
  store.set({ t: 0.85 }, user);
  store.undo();
  expect(store.state.t).toBe(0.5);
});

test("cancelling a drag gives the state before it", () => {
  const store = fresh();
  store.set({ t: 0.8 }, { ...user, commit: false });
  store.cancel();
  expect(store.state.t).toBe(0.5);
  expect(store.canUndo).toBe(false);
});

test("a commit that changes nothing is no step", () => {
  const store = fresh();
  store.set({ t: 0.5 }, user);
  expect(store.canUndo).toBe(false);
});

test("key presses in quick succession are one step, later ones another", () => {
  const store = fresh();
  const press = (t: number, time: number) => store.set({ t }, { ...user, merge: { kind: "t", time } });
  press(0.6, 0);
  press(0.7, 300);
  press(0.8, 5000);
  store.undo();
  expect(store.state.t).toBe(0.7);
  store.undo();
  expect(store.state.t).toBe(0.5);
});

test("reset is a step of its own", () => {
  const store = fresh();
  store.set({ t: 0.8 }, user);
  store.reset(changed(sample, store.state, { t: 0.5 }));
  expect(store.state.t).toBe(0.5);
  store.undo();
  expect(store.state.t).toBe(0.8);
});

test("listeners hear who changed what, and whether it is committed", () => {
  const store = fresh();
  const heard: string[] = [];
  store.listen(({ state, source, committed }) => heard.push(`${state.t} ${source} ${committed}`));
  store.set({ t: 0.6 }, { ...user, commit: false });
  store.set({ t: 0.7 }, { source: "program" });
  store.undo();
  expect(heard).toEqual(["0.6 user false", "0.7 program true", "0.5 user true"]);
});
