import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import type { Plugin } from "vite";
import { buildWorkshop, devWorkshop, type Workshop } from "../workshop.ts";

const THEME = "src/render/theme.ts";

/**
 * Style sheets that are made, not written: `virtual:theme.css` from the one theme table, `virtual:katex.css`
 * from KaTeX without its fonts, which come with the page's other fonts.
 */
export function virtualStyles(): Plugin {
  let root = "";
  let workshop: Workshop | null = null;
  return {
    name: "straklatte:styles",
    configResolved(config) {
      root = config.root;
    },
    configureServer(server) {
      workshop = devWorkshop(server);
    },
    resolveId: (id) => (/^virtual:(theme|katex)\.css$/.test(id) ? `\0${id}` : null),
    async load(id) {
      if (id === "\0virtual:katex.css") return katexCss();
      if (id !== "\0virtual:theme.css") return null;
      this.addWatchFile(`${root}/${THEME}`);
      const own = workshop ?? (await buildWorkshop(root));
      const theme = await own.load<typeof import("../../render/theme.ts")>(`/${THEME}`);
      if (own !== workshop) await own.close();
      return theme.themeCss() + theme.indexCss() + theme.figureCss("curve-demo > svg");
    },
  };
}

function katexCss(): string {
  const file = createRequire(import.meta.url).resolve("katex/dist/katex.min.css");
  return readFileSync(file, "utf8").replace(/@font-face\s*\{[^}]*\}/g, "");
}
