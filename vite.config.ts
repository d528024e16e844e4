import { defineConfig } from "vitest/config";
import { straklatte } from "./src/build/plugin.ts";

const port = Number(process.env.PORT ?? 4173);

export default defineConfig({
  base: "./",
  appType: "mpa",
  // The package does not export its style sheet.
  resolve: {
    alias: [{ find: /^lil-gui\/dist/, replacement: `${import.meta.dirname}/node_modules/lil-gui/dist` }],
  },
  plugins: process.env.VITEST ? [] : [straklatte()],
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
    reporters: ["default", ["json", { outputFile: "reports/unit.json" }]],
  },
});
