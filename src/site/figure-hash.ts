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

/** Puts a figure into a state, gliding, and brings it into view if less than most of it is seen. */
export async function show({ figure, query }: Place): Promise<void> {
  const stage = figure.querySelector("curve-demo") ?? figure;
  const { top, bottom, height } = stage.getBoundingClientRect();
  const seen = Math.min(bottom, innerHeight) - Math.max(top, 0);
  if (seen < 0.8 * Math.min(height, innerHeight)) {
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    stage.scrollIntoView({ block: "nearest", behavior: calm ? "instant" : "smooth" });
  }
  (await demoOf(figure))?.applyQuery(query, { glide: true });
}

/** Opens the page at a figure, in a state: nothing glides, since nothing was seen before. */
async function open({ figure, query }: Place): Promise<void> {
  figure.scrollIntoView({ block: "start", behavior: "instant" });
  (await demoOf(figure))?.applyQuery(query);
}

/**
 * The address of the page holds the state of the figure changed last: read on opening and whenever it
 * changes, written when a change is complete. It replaces the entry in the history, so that "back" leaves
 * the page; undo is the figure's own.
 */
export function figureHash(main: HTMLElement): void {
  const openHash = () => {
    const place = readHash(location.hash);
    if (place) void open(place);
  };
  main.addEventListener("statechange", (event) => {
    const { committed } = (event as CustomEvent<Change>).detail;
    const demo = event.target as CurveDemo;
    const figure = demo.closest("figure[id]");
    if (committed && figure) write(figure.id, demo.query);
  });
  addEventListener("hashchange", openHash);
  openHash();
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
