import { recall, remember } from "./storage.ts";

/**
 * Links to the other language remember the choice, and carry the place and the state of the figure along:
 * ids are the same in both languages.
 */
export function languageLinks(links: Iterable<HTMLAnchorElement>): void {
  for (const link of links) {
    const choose = () => {
      remember("language", link.dataset.language ?? null);
      link.hash = location.hash;
    };
    link.addEventListener("click", choose);
    link.addEventListener("auxclick", choose);
  }
}

/** On the page that asks for the language: who has chosen before goes on at once. */
export function forwardToChosen(): void {
  const language = recall("language");
  if (language === "de" || language === "en") location.replace(`${language}/`);
}
