import { defineConfig } from "vitest/config";
import { straklatte } from "./src/build/plugin.ts";
import { panelStyles } from "./src/build/plugins/panel-styles.ts";

const port = Number(process.env.PORT ?? 4173);

export default defineConfig({
  base: "./",
  appType: "mpa",
  plugins: process.env.VITEST ? [panelStyles()] : [straklatte()],
  preview: { port, strictPort: true },
  build: {
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    // three, which only pages with surfaces load.
    chunkSizeWarningLimit: 600,
  },
  test: {
    include: ["tests/**/*.test.ts"],
    environment: "node",
    // Property tests take their time on a small machine.
    testTimeout: 60_000,
    reporters: ["default", ["json", { outputFile: "reports/unit.json" }]],
  },
});
