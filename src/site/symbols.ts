import { type Lighting, readTie } from "./lighting.ts";
import { putBeside } from "./put-beside.ts";
import { meaningOf } from "./symbol-meaning.ts";

/** How long the pointer rests on a symbol before its meaning is told. */
const REST = 450;

/**
 * Pointing at a symbol of a formula lights it and what it stands for; resting on it, or tapping it, tells its meaning.
 * Only the pointer listens here: the keyboard has the list behind the button after the formula.
 */
export function symbols(main: HTMLElement, { point }: Lighting): void {
  let current: Element | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const tip = document.createElement("div");
  tip.className = "symbol-tip";
  tip.popover = "manual";
  main.append(tip);

  const hide = () => {
    clearTimeout(timer);
    if (tip.matches(":popover-open")) tip.hidePopover();
  };
  const tell = (symbol: HTMLElement) => {
    const meaning = meaningOf(symbol.dataset.symbol);
    if (!meaning) return;
    tip.replaceChildren(...meaning);
    tip.showPopover();
    putBeside(tip, symbol.getBoundingClientRect());
  };
  const enter = (symbol: HTMLElement | null, wait: number) => {
    if (symbol === current) return;
    current = symbol;
    clearTimeout(timer);
    const around: HTMLElement[] = [];
    for (let one = symbol; one; one = one.parentElement?.closest<HTMLElement>("[data-tie]") ?? null)
      around.push(one);
    point(around.flatMap(({ dataset }) => (dataset.tie ? readTie(dataset.tie) : [])));
    timer = setTimeout(() => (symbol ? tell(symbol) : hide()), symbol ? wait : REST / 2);
  };
  const symbolAt = (target: EventTarget | null) =>
    (target as Element | null)?.closest<HTMLElement>("[data-symbol], [data-tie]") ?? null;

  main.addEventListener("pointerover", (event) => {
    if (event.pointerType === "touch") return;
    // The tip may be pointed at itself, without going away.
    if (tip.contains(event.target as Node)) clearTimeout(timer);
    else enter(symbolAt(event.target), REST);
  });
  main.addEventListener("pointerleave", () => enter(null, 0));
  main.addEventListener("click", (event) => {
    const symbol = symbolAt(event.target);
    if (symbol && !(event.target as Element).closest("a, button, [role=option]")) {
      current = null;
      enter(symbol, 0);
    } else if (current && !tip.contains(event.target as Node)) {
      enter(null, 0);
      hide();
    }
  });
  addEventListener("keydown", (event) => {
    if (event.key === "Escape") hide();
  });
  addEventListener("scroll", hide, { passive: true });
}
