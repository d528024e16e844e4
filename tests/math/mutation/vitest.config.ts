import { defineConfig } from "vitest/config";

// The tests of src/math as mutation runs them: alone, with few runs of each property, ending at the first failure.
export default defineConfig({
  test: { include: ["tests/math/**/*.test.ts"], env: { PROPERTY_RUNS: "25" }, bail: 1 },
});
