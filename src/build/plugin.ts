import type { Plugin } from "vite";
import { notFound } from "./plugins/not-found.ts";
import { pagesInBuild } from "./plugins/pages-in-build.ts";
import { pagesInDev } from "./plugins/pages-in-dev.ts";
import { panelStyles } from "./plugins/panel-styles.ts";
import { virtualStyles } from "./plugins/virtual-styles.ts";

/** Everything that turns lessons and demos into a site. */
export function straklatte(): Plugin[] {
  return [panelStyles(), virtualStyles(), pagesInDev(), pagesInBuild(), notFound()];
}
