import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";
import type { BoundField, Gui, PutField } from "./panel-gui.ts";
import { SHORTCUTS } from "./shortcuts.ts";
import { WORDS } from "./words.ts";

export interface PanelAction {
  readonly label: string;
  readonly possible: boolean;
  run(): void;
}

export interface Panel {
  readonly root: HTMLElement;
  readonly open: boolean;
  toggle(): void;
  /** Shows the current fields and actions, if the panel is open. */
  update(): void;
}

export interface PanelSource {
  readonly lang: Lang;
  fields(): readonly BoundField[];
  actions(): readonly PanelAction[];
  readonly put: PutField;
  /** Moves the point that was selected last. */
  nudge(direction: readonly [number, number]): void;
}

/**
 * The collapsed panel below the figure: number fields for everything (dragging is never the only way),
 * what can be added or taken away, buttons that move the selected point, and the keys. Its contents are
 * loaded and built when it is opened for the first time.
 */
export function createPanel(source: PanelSource, loadStyles: () => Promise<void>): Panel {
  const lang = source.lang;
  const numbers = element("div", { class: "numbers" });
  const actions = element("div", { class: "actions" });
  const root = element("div", { class: "panel" }, actions, numbers, nudgeRow(source), help(lang));
  root.hidden = true;
  let gui: Gui | undefined;
  let shape = "";
  let loading = false;

  const build = async () => {
    loading = true;
    const [{ createGui }] = await Promise.all([import("./panel-gui.ts"), loadStyles()]);
    loading = false;
    const fields = source.fields();
    shape = shapeOf(fields);
    gui?.destroy();
    gui = createGui(numbers, fields, lang, source.put);
  };
  const update = () => {
    if (root.hidden) return;
    showActions(actions, source.actions());
    const fields = source.fields();
    if (gui && shape === shapeOf(fields)) gui.update(fields);
    else if (!loading) void build();
  };
  return {
    root,
    get open() {
      return !root.hidden;
    },
    toggle() {
      root.hidden = !root.hidden;
      update();
    },
    update,
  };
}

const shapeOf = (fields: readonly BoundField[]) => fields.map(({ field }) => field.id).join(" ");

function showActions(row: HTMLElement, actions: readonly PanelAction[]): void {
  if (row.childElementCount !== actions.length) {
    row.replaceChildren(...actions.map((action) => element("button", { type: "button" }, action.label)));
  }
  actions.forEach((action, i) => {
    const button = row.children[i] as HTMLButtonElement;
    button.disabled = !action.possible;
    button.onclick = () => action.run();
  });
}

function nudgeRow(source: PanelSource): HTMLElement {
  const { lang } = source;
  const button = (arrow: string, name: string, direction: readonly [number, number]) => {
    const made = element("button", { type: "button", "aria-label": name, title: name }, arrow);
    made.addEventListener("click", () => source.nudge(direction));
    return made;
  };
  return element(
    "div",
    { class: "nudge", role: "group", "aria-label": WORDS.nudge[lang] },
    element("span", {}, WORDS.nudge[lang]),
    button("←", WORDS.left[lang], [-1, 0]),
    button("→", WORDS.right[lang], [1, 0]),
    button("↑", WORDS.up[lang], [0, 1]),
    button("↓", WORDS.down[lang], [0, -1]),
  );
}

function help(lang: Lang): HTMLElement {
  const list = element("dl", {});
  for (const { keys, does } of SHORTCUTS) {
    list.append(element("dt", {}, keys[lang]), element("dd", {}, does[lang]));
  }
  return element("details", { class: "help" }, element("summary", {}, WORDS.keyboard[lang]), list);
}
