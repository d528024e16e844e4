import { element } from "./element.ts";

/** Lasting, visible notes in the figure; an offer to reload where that helps. */
export function showProblems(place: HTMLElement, texts: readonly string[], retry?: string): void {
  place.replaceChildren(...texts.map((text) => element("p", {}, text)));
  if (retry) {
    const button = element("button", { type: "button" }, retry);
    button.addEventListener("click", () => location.reload());
    place.append(button);
  }
}
