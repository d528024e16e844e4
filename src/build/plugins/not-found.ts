import { existsSync, readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import type { Plugin } from "vite";

/** Lets `npm start` answer as a static host does: a folder gets its slash, what is missing gets 404.html. */
export function notFound(): Plugin {
  return {
    name: "straklatte:not-found",
    configurePreviewServer(server) {
      const dist = resolve(server.config.root, server.config.build.outDir);
      return () => {
        server.middlewares.use((request, response, next) => {
          const url = new URL(request.originalUrl ?? "/", "http://localhost");
          const path = decodeURIComponent(url.pathname);
          const index = path.endsWith("/") ? "index.html" : "";
          if (existsSync(join(dist, path, index)) && (index || path.endsWith(".html"))) return next();
          if (!index && existsSync(join(dist, path, "index.html"))) {
            response.writeHead(301, { Location: `${url.pathname}/${url.search}` });
            return response.end();
          }
          const page = join(dist, "404.html");
          response.writeHead(404, { "Content-Type": "text/html; charset=utf-8" });
          response.end(existsSync(page) ? readFileSync(page) : "404");
        });
      };
    },
  };
}
