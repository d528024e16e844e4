import { element } from "./element.ts";

const WAIT = 450;
let region: HTMLElement | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;

/** Says politely how things are, once they have come to rest. One region serves the whole page. */
export function announce(text: () => string, lang: string): void {
  if (!region) {
    region = element("div", { role: "status", "aria-live": "polite" });
    Object.assign(region.style, {
      position: "absolute",
      width: "1px",
      height: "1px",
      overflow: "hidden",
      clipPath: "inset(50%)",
      whiteSpace: "nowrap",
    });
    document.body.append(region);
  }
  const target = region;
  clearTimeout(timer);
  timer = setTimeout(() => {
    target.lang = lang;
    target.textContent = text();
  }, WAIT);
}
