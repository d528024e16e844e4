import { defineConfig } from "vitest/config";

// Line coverage of src/math by its own tests: `npm run test:coverage` fails below 98 %.
export default defineConfig({
  test: {
    testTimeout: 120_000, // instrumented code is slow
    include: ["tests/math/**/*.test.ts"],
    coverage: {
      include: ["src/math/**/*.ts"],
      reporter: ["text"],
      thresholds: { lines: 98 },
    },
  },
});
