import { describe, expect, test } from "vitest";
import { type Adapter, readOracles, runCase } from "./oracle.ts";

// Adapters are merged: a foreign data set may sort the same operations into other topics.
const modules = import.meta.glob<{ adapter: Adapter }>("./oracles/*.ts", { eager: true });
const adapter: Record<string, Adapter[string]> = {};
for (const [file, module] of Object.entries(modules)) {
  for (const [op, run] of Object.entries(module.adapter)) {
    if (Object.hasOwn(adapter, op)) throw new Error(`${file}: op "${op}" has an adapter already`);
    adapter[op] = run;
  }
}

for (const { file, cases } of readOracles(process.env.ORACLES ?? "tests/oracles")) {
  describe(file, () => {
    test("has cases", () => expect(cases.length).toBeGreaterThan(0));
    for (const oracle of cases) {
      test(oracle.name, () => expect(runCase(adapter, oracle)).toEqual([]));
    }
  });
}
