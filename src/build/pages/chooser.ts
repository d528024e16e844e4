import { chooserPage } from "../templates/chooser-page.ts";
import { SITE_NAME } from "../templates/words.ts";
import { DESCRIPTION } from "./descriptions.ts";
import type { Page } from "./page.ts";

/** The root: the reader chooses a language. */
export function chooser(): Page {
  return {
    path: "",
    lang: "de",
    title: SITE_NAME,
    description: `${DESCRIPTION.de} ${DESCRIPTION.en}`,
    bodyClass: "chooser-page",
    assets: "page",
    alternate: null,
    chrome: null,
    sources: [],
    body: chooserPage,
  };
}
