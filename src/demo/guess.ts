import type { Demo } from "./define.ts";
import type { Params } from "./param.ts";
import { points } from "./params/points.ts";

/**
 * The demo with one point more, which means nothing to it: where a reader guesses something to be. It is a parameter like
 * the others, so that mouse, keys, undo and address know it without more ado.
 *
 * @param text the view and where the mark begins: `plane 0.3,2.8`. Anything else leaves the demo as it is.
 */
export function withGuess(demo: Demo, text: string | null): Demo {
  const parts = /^(\S+) (-?[\d.]+),(-?[\d.]+)$/.exec(text ?? "");
  const view = parts?.[1] ?? "";
  const window = demo.views[view];
  const at = parts ? [Number(parts[2]), Number(parts[3])] : [];
  if (!window || window.space || demo.params.guess || !at.every(Number.isFinite)) return demo;
  const guess = points({
    initial: [at],
    label: { de: "Ihr Tipp", en: "Your guess" },
    names: [{ base: { de: "Ihr Tipp", en: "your guess" }, style: "text" }],
    view,
    x: window.x,
    y: window.y,
    indexed: false,
  });
  return { ...demo, params: { ...demo.params, guess } as Params };
}
