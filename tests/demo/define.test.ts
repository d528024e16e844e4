import { expect, test } from "vitest";
import { defineDemo, number } from "../../src/demo/index.ts";

const label = { de: "a", en: "b" };
const t = number({ initial: 0, min: 0, max: 1, step: 0.1, label });
const rest = {
  title: label,
  views: {},
  values: () => ({}),
  scene: () => ({}),
  describe: () => label,
};

test("ids and reserved names are refused by name", () => {
  expect(() => defineDemo({ id: "Bad", params: {}, ...rest })).toThrow(/"Bad" must match/);
  expect(() => defineDemo({ id: "ok", params: { Big: t }, ...rest })).toThrow(/"Big" must match/);
  expect(() => defineDemo({ id: "ok", params: { theme: t }, ...rest })).toThrow(/"theme" is reserved/);
});

test("initial values and named states must be values that the parameters accept", () => {
  const off = number({ initial: 2, min: 0, max: 1, step: 0.1, label });
  expect(() => defineDemo({ id: "ok", params: { t: off }, ...rest })).toThrow(/initial value of "t"/);
  expect(() => defineDemo({ id: "ok", params: { t }, ...rest, states: { far: { t: 9 } } })).toThrow(
    /state "far": t/,
  );
  expect(() => defineDemo({ id: "ok", params: { t }, ...rest, states: { far: { u: 1 } as never } })).toThrow(
    /unknown parameter "u"/,
  );
});
