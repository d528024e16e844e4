import type { Plugin, ViteDevServer } from "vite";
import { type Assets, ENTRIES } from "../assets.ts";
import { FACES, faceRule } from "../fonts/faces.ts";
import type { Page } from "../pages/page.ts";
import { problemsText } from "../problem.ts";
import type { Site } from "../site.ts";
import { devWorkshop } from "../workshop.ts";

/** Fonts as their packages bring them. */
const FONTS = "@straklatte/fonts.css";

const ASSETS: Assets = {
  page: { styles: [FONTS], scripts: [ENTRIES.page], fonts: [] },
  embed: { styles: [FONTS], scripts: [ENTRIES.embed], fonts: [] },
};

/** Serves the pages while writing: each request makes its page anew, each saved lesson reloads the browser. */
export function pagesInDev(): Plugin {
  return {
    name: "straklatte:dev",
    apply: "serve",
    config: () => ({ optimizeDeps: { entries: Object.values(ENTRIES) } }),
    // What the pages are made from need not be loaded in the browser: a still picture changes with its demo.
    hotUpdate({ modules, server }) {
      if (this.environment.name === "ssr" && modules.length > 0) server.ws.send({ type: "full-reload" });
    },
    configureServer(server) {
      const { watcher, middlewares, config } = server;
      watcher.on("all", (_, file) => {
        if (/\.md$/.test(file) && file.startsWith(`${config.root}/lessons/`))
          server.ws.send({ type: "full-reload" });
      });
      middlewares.use((request, response, next) => {
        const path = new URL(request.url ?? "/", "http://localhost").pathname.slice(1);
        if (path === FONTS) {
          response.setHeader("Content-Type", "text/css");
          return response.end(FACES.map((face) => faceRule(face, `/node_modules/${face.file}`)).join("\n"));
        }
        if (path !== "" && !path.endsWith("/")) return next();
        answer(server, path)
          .then((html) => {
            if (html === null) return next();
            response.setHeader("Content-Type", "text/html; charset=utf-8");
            response.end(html);
          })
          .catch(next);
      });
    },
  };
}

/** The document at a path; null if there is no such page. */
async function answer(server: ViteDevServer, path: string): Promise<string | null> {
  const { root } = server.config;
  const { openSite } = await devWorkshop(server).load<typeof import("../site.ts")>("/src/build/site.ts");
  const site = await openSite({ root, policy: false, siteUrl: null });
  const page = site.pages.find((one) => one.path === path);
  if (!page) return null;
  stopAtProblems(site, page);
  // Vite would parse the whole document for this one line.
  return site
    .render(page, ASSETS)
    .replace("<head>", '<head>\n<script type="module" src="/@vite/client"></script>');
}

/** A lesson with problems is not shown; those of other lessons do not get into the way. */
function stopAtProblems(site: Site, page: Page): void {
  const own = site.problems.filter(({ file }) => page.sources.includes(file));
  if (own.length === 0) return;
  const { file, line } = own[0]!;
  throw Object.assign(new Error(problemsText(own)), { loc: { file, line, column: 0 }, stack: "" });
}
