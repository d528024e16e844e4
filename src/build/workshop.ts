import { createServer, isRunnableDevEnvironment, type ViteDevServer } from "vite";

/** Loads the project's own TypeScript modules, always as they are on disk. */
export interface Workshop {
  load<T>(path: string): Promise<T>;
  close(): Promise<void>;
}

/** The workshop of a running dev server: a changed module, and all that import it, are read anew. */
export function devWorkshop(server: ViteDevServer): Workshop {
  const { ssr } = server.environments;
  if (!ssr || !isRunnableDevEnvironment(ssr)) throw new Error("the dev server cannot run modules");
  return { load: (path) => ssr.runner.import(path), close: async () => {} };
}

/** A workshop for one build: a dev server without a port, a watcher or a browser. */
export async function buildWorkshop(root: string): Promise<Workshop> {
  const server = await createServer({
    root,
    configFile: false,
    appType: "custom",
    logLevel: "error",
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
    optimizeDeps: { noDiscovery: true },
  });
  return { ...devWorkshop(server), close: () => server.close() };
}
