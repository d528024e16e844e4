import { createRequire } from "node:module";
import { dirname } from "node:path";
import type { Plugin } from "vite";

/** Lets `lil-gui/dist/lil-gui.css` be imported: the package has the file, but does not export it. */
export function panelStyles(): Plugin {
  const folder = dirname(createRequire(import.meta.url).resolve("lil-gui"));
  return {
    name: "straklatte:panel-styles",
    config: () => ({ resolve: { alias: [{ find: /^lil-gui\/dist(?=\/)/, replacement: folder }] } }),
  };
}
