import type { CurveDemo } from "../player/index.ts";
import { demoOf } from "./player.ts";

/** What `statechange` of a figure carries. */
interface Change {
  readonly committed: boolean;
}

/** A figure and a state of it, as the hash of an address or a link says: `#figure-id?t=0.5`. */
export interface Place {
  readonly figure: HTMLElement;
  readonly query: string;
}

/** The figure and state that a hash names; null for ordinary anchors. */
export function readHash(hash: string): Place | null {
  const cut = hash.indexOf("?");
  if (!hash.startsWith("#") || cut < 0) return null;
  const figure = document.getElementById(hash.slice(1, cut));
  return figure ? { figure, query: hash.slice(cut + 1) } : null;
}

/** Puts a figure into a state, gliding, and brings it into view if it is out of sight. */
export async function show({ figure, query }: Place, glide: boolean): Promise<void> {
  const { top, bottom } = figure.getBoundingClientRect();
  const unseen = bottom < 120 || top > innerHeight - 120;
  if (unseen) {
    const calm = !glide || matchMedia("(prefers-reduced-motion: reduce)").matches;
    figure.scrollIntoView({ block: "start", behavior: calm ? "instant" : "smooth" });
  }
  (await demoOf(figure))?.applyQuery(query, { glide });
}

/**
 * The address of the page holds the state of the figure changed last: read on opening and whenever it
 * changes, written when a change is complete. It replaces the entry in the history, so that "back" leaves
 * the page; undo is the figure's own.
 */
export function figureHash(main: HTMLElement): void {
  const open = (glide: boolean) => {
    const place = readHash(location.hash);
    if (place) void show(place, glide);
  };
  main.addEventListener("statechange", (event) => {
    const { committed } = (event as CustomEvent<Change>).detail;
    const demo = event.target as CurveDemo;
    const figure = demo.closest("figure[id]");
    if (committed && figure) write(figure.id, demo.query);
  });
  addEventListener("hashchange", () => open(true));
  open(false);
}

function write(id: string, query: string): void {
  const mine = location.hash === `#${id}` || location.hash.startsWith(`#${id}?`);
  const hash = query ? `#${id}?${query}` : mine ? `#${id}` : "";
  if (hash === "" || hash === location.hash) return;
  try {
    history.replaceState(history.state, "", hash);
  } catch {
    // Too many changes for the browser's patience, or a host that refuses: the figure works without.
  }
}
