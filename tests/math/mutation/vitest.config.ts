import { defineConfig } from "vitest/config";

// The tests of src/math as mutation runs them: alone, with few runs of each property, ending at the first failure, and
// without the ones that only measure.
export default defineConfig({
  test: {
    testTimeout: 120_000, // instrumented code is slow
    testNamePattern: /^(?!.*a million points)/,
    include: (process.env.MUTATION_TESTS ?? "tests/math/**/*.test.ts").split(","),
    env: { PROPERTY_RUNS: "25" },
    bail: 1,
  },
});
