import { themeCss } from "../render/theme.ts";
import controls from "./styles/controls.css?inline";
import figure from "./styles/figure.css?inline";
import space from "./styles/space.css?inline";

let shared: CSSStyleSheet[] | undefined;
let panel: CSSStyleSheet | undefined;

function sheet(text: string): CSSStyleSheet {
  const made = new CSSStyleSheet();
  made.replaceSync(text);
  return made;
}

/** The style sheets that every figure shares: made once a page, adopted by each shadow root. */
export function adoptStyles(root: ShadowRoot): void {
  shared ??= [sheet(themeCss(".shell")), sheet(figure), sheet(controls), sheet(space)];
  root.adoptedStyleSheets = shared;
}

/** The panel's own sheets come when a panel is opened for the first time. */
export async function addPanelStyles(root: ShadowRoot): Promise<void> {
  if (!panel) {
    const [library, own] = await Promise.all([
      import("lil-gui/dist/lil-gui.css?inline"),
      import("./styles/panel.css?inline"),
    ]);
    panel = sheet(`${library.default.replace(/@font-face\s*{[^}]*}/g, "")}\n${own.default}`);
  }
  if (!root.adoptedStyleSheets.includes(panel)) root.adoptedStyleSheets = [...root.adoptedStyleSheets, panel];
}
