import type { Demo } from "../../demo/index.ts";
import { initialState } from "../../demo/state.ts";
import { embedPage } from "../templates/embed-page.ts";
import type { Page, PageContext } from "./page.ts";

/** One demo alone, for frames and slides. Its language comes with the query, so one page serves both. */
export function embed(demo: Demo, { still }: PageContext): Page {
  return {
    path: `embed/${demo.id}/`,
    lang: "de",
    title: demo.title.de,
    description: `${demo.title.de}. ${demo.title.en}.`,
    bodyClass: "embed-page",
    assets: "embed",
    alternate: null,
    chrome: null,
    noindex: true,
    sources: [],
    body: () =>
      embedPage({
        title: demo.title,
        figure: {
          id: demo.id,
          demo: demo.id,
          lang: "de",
          attributes: {},
          ...still(demo, initialState(demo), "de"),
          caption: "",
          printCaption: "",
        },
      }),
  };
}
