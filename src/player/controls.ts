import type { Param } from "../demo/param.ts";
import type { Core } from "./core.ts";
import { element } from "./element.ts";
import { createMainSlider } from "./main-slider.ts";
import { createPanel } from "./panel.ts";
import type { BoundField } from "./panel-gui.ts";
import { createToolbar, type ToolSpec } from "./toolbar.ts";
import { WORDS } from "./words.ts";

/** The rows below the picture: main slider and toolbar, and the panel. */
export interface Controls {
  readonly bar: HTMLElement;
  /** null where the frame asks for less. */
  readonly panel: HTMLElement | null;
  update(): void;
}

export interface ControlActions {
  fullscreen(): void;
  nudgeSelected(direction: readonly [number, number]): void;
  /** The pencil, for a figure that has one. */
  readonly pencil: { readonly on: boolean; toggle(on: boolean): void } | null;
  loadPanelStyles(): Promise<void>;
}

export function createControls(core: Core, actions: ControlActions): Controls {
  const { demo, store, mover, options, embedded, request } = core;
  const { lang } = options;
  const params = Object.entries(demo.params) as [string, Param<unknown>][];
  const around = () => ({ state: store.state, views: demo.views });
  const fields = (): BoundField[] =>
    params.flatMap(([param, declared]) =>
      declared.fields(param, store.state[param], around()).map((field) => ({ param, field })),
    );

  const main = params.find(([, param]) => param.primary);
  const mainField = () => {
    const field = main?.[1].fields(main[0], store.state[main[0]], around())[0];
    return field?.kind === "number" ? field : null;
  };
  const first = mainField();
  const slider =
    main && first
      ? createMainSlider(first, lang, embedded, (value, commit, event) => {
          const [id, param] = main;
          const merge = event instanceof KeyboardEvent ? { kind: id, time: event.timeStamp } : undefined;
          mover.put(id, param.round(value), commit, merge);
        })
      : null;
  if (slider && main) slider.root.dataset.param = main[0];

  const panel =
    options.controls === "full" && !options.still
      ? createPanel(
          {
            lang,
            fields,
            actions: () =>
              params.flatMap(([id, param]) =>
                param.actions(store.state[id]).map((action) => ({
                  label: action.label[lang],
                  possible: action.value !== null,
                  run: () => action.value !== null && mover.put(id, action.value, true),
                })),
              ),
            put: (id, value, commit) => {
              const bound = fields().find(({ field }) => field.id === id);
              if (bound)
                mover.put(bound.param, (bound.field.put as (next: unknown) => unknown)(value), commit);
            },
            nudge: actions.nudgeSelected,
          },
          actions.loadPanelStyles,
        )
      : null;

  const toolbar = createToolbar(demo.title[lang], tools());
  function tools(): ToolSpec[] {
    const { pencil } = actions;
    const say = (word: keyof typeof WORDS) => WORDS[word][lang];
    const all: (ToolSpec | false)[] = [
      mover.canPlay && {
        id: "play",
        run: () => mover.play(!mover.moving),
        look: () =>
          mover.moving ? { name: say("pause"), icon: "pause" } : { name: say("play"), icon: "play" },
      },
      pencil !== null && {
        id: "pencil",
        run: () => {
          pencil.toggle(!pencil.on);
          request();
        },
        look: () => ({ name: say("pencil"), pressed: pencil.on }),
      },
      {
        id: "undo",
        run: () => mover.travel(store.undo),
        look: () => ({ name: say("undo"), disabled: !store.canUndo }),
      },
      {
        id: "redo",
        run: () => mover.travel(store.redo),
        look: () => ({ name: say("redo"), disabled: !store.canRedo }),
      },
      {
        id: "reset",
        run: () => mover.travel(() => store.reset(core.own())),
        look: () => ({ name: say("reset") }),
      },
      !embedded && { id: "fullscreen", run: actions.fullscreen, look: () => ({ name: say("fullscreen") }) },
      panel !== null && {
        id: "values",
        run: () => {
          panel.toggle();
          request();
        },
        look: () => ({ name: say("values"), pressed: panel.open }),
      },
    ];
    return all.filter((spec) => spec !== false);
  }
  return {
    bar: element("div", { class: "bar" }, ...(slider ? [slider.root] : []), toolbar.root),
    panel: panel?.root ?? null,
    update() {
      slider?.update(mainField()!);
      toolbar.update();
      panel?.update();
    },
  };
}
