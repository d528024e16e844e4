import type { CurveDemo } from "../player/index.ts";
import { readHash, show } from "./figure-hash.ts";

/**
 * Words that put a figure into a state. They are ordinary links; here they glide instead of jumping, leave no
 * trace in the history, and show whether the figure is in their state.
 */
export function stateLinks(main: HTMLElement): void {
  const byFigure = new Map<Element, { link: HTMLAnchorElement; query: string }[]>();
  for (const link of main.querySelectorAll<HTMLAnchorElement>("a.state-link")) {
    const place = readHash(link.hash);
    if (!place) continue;
    const list = byFigure.get(place.figure) ?? [];
    list.push({ link, query: place.query });
    byFigure.set(place.figure, list);
    link.addEventListener("click", (event) => {
      if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
      event.preventDefault();
      void show(place);
    });
  }
  const look = (event: Event) => {
    const demo = event.target as CurveDemo;
    const links = byFigure.get(demo.closest("figure") ?? demo) ?? [];
    // On the way, in a drag, the figure is in no state; what it is in is seen once it is there.
    const onTheWay = event instanceof CustomEvent && event.detail?.committed === false;
    for (const { link, query } of links) {
      const on = !onTheWay && (query ? demo.inState(query) : demo.query === "");
      if (on) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
    }
  };
  main.addEventListener("statechange", look);
  main.addEventListener("curve-demo-ready", look);
}
