import { figureBox } from "../demo/box.ts";
import type { Demo } from "../demo/define.ts";
import type { Figure } from "../demo/figure.ts";
import type { Param, State } from "../demo/param.ts";
import type { Problem } from "../demo/state.ts";
import { announce } from "./announcer.ts";
import { createControls } from "./controls.ts";
import { createCore } from "./core.ts";
import { element } from "./element.ts";
import { type FrameOptions, isDark } from "./frame.ts";
import { createHandleLayer } from "./handle-layer.ts";
import { listen } from "./input.ts";
import type { Mover } from "./mover.ts";
import { createPencil } from "./pencil.ts";
import { listenToPointing } from "./pointing.ts";
import { showProblems } from "./problems.ts";
import { createReadout } from "./readout.ts";
import type { createSpaceControls } from "./space-controls.ts";
import { createStage } from "./stage.ts";
import type { Change, Store } from "./store.ts";
import { addPanelStyles } from "./styles.ts";
import { WORDS } from "./words.ts";

/** One living figure. */
export interface Player {
  readonly store: Store;
  readonly mover: Mover;
  readonly figure: Figure;
  report(problems: readonly Problem[]): void;
  /** Marks and sliders lit up because their symbol is pointed at. */
  light(names: ReadonlySet<string>): void;
  /** The theme or the fonts have changed. */
  redraw(): void;
  destroy(): void;
}

export interface PlayerSetup {
  readonly demo: Demo;
  readonly root: ShadowRoot;
  readonly initial: State;
  /** The state that reset goes back to: the figure's own initial one. */
  own(): State;
  readonly options: FrameOptions;
  readonly embedded: boolean;
  /** What a figure needs that looks into space. */
  readonly inSpace?: typeof createSpaceControls | undefined;
  /** Called at most once a frame. */
  changed(change: Change): void;
  /** What is pointed at in the figure, by name; called when that changes. */
  pointed(names: readonly string[]): void;
}

/** Builds a figure into a shadow root and draws it at once; from then on it follows its state. */
export function createPlayer(setup: PlayerSetup): Player {
  const { demo, root, options, embedded } = setup;
  const { lang, still, controls } = options;
  const core = createCore(demo, setup.initial, options, { embedded, own: setup.own, request });

  const description = element("p", { class: "description", id: "description" });
  const stage = createStage(options, request);
  const layer = createHandleLayer(lang);
  const readout = createReadout(lang, WORDS.readout[lang]);
  const problems = element("div", { class: "problems", role: "status" });
  const pencil = pencilOf();
  const shell = buildShell();
  const input = listen(shell, core, stage, layer, pencil);
  listenToPointing(shell, core, stage, layer, setup.pointed);
  const space = setup.inSpace?.(core, stage, layer) ?? null;
  const rows = createControls(core, {
    fullscreen: () => void enterFullscreen(),
    nudgeSelected: input.nudgeSelected,
    pencil,
    loadPanelStyles: () => addPanelStyles(root),
  });
  if (space) stage.root.append(...space.under);
  if (!still) stage.root.append(layer.root);
  if (space) stage.root.append(...space.over);
  shell.append(stage.root);
  if (!still && controls !== "none") shell.append(rows.bar);
  if (demo.readout) shell.append(readout.root);
  shell.append(problems, ...(rows.panel ? [rows.panel] : []), description);

  function buildShell(): HTMLElement {
    const state = [`controls-${controls}`, embedded ? "is-embedded" : "", still ? "is-still" : ""].join(" ");
    const made = element("div", {
      class: `shell ${state}`,
      role: "group",
      "aria-label": demo.title[lang],
      "aria-describedby": "description",
      lang,
    });
    const box = figureBox(demo);
    made.style.setProperty("--wide", String(box.wide));
    made.style.setProperty("--narrow", String(box.narrow));
    return made;
  }

  function pencilOf() {
    const drawn = (Object.entries(demo.params) as [string, Param<unknown>][]).find(
      ([, param]) => param.drawnIn,
    );
    if (!drawn || still) return null;
    const [id, param] = drawn;
    const made = createPencil(
      stage.root,
      lang,
      param.drawnIn!,
      () => core.store.state[id] as readonly (readonly number[])[],
      (points, commit) => core.mover.put(id, param.round(points), commit),
    );
    layer.root.append(made.cross);
    return made;
  }

  async function enterFullscreen(): Promise<void> {
    try {
      if (document.fullscreenElement) await document.exitFullscreen();
      else await (root.host as HTMLElement).requestFullscreen();
    } catch {
      showProblems(problems, [WORDS.noFullscreen[lang]]);
    }
  }

  let lit: ReadonlySet<string> = new Set();
  let frame = 0;
  let pending: Change | null = null;
  let broken = false;
  /** On the way to somewhere: a drag, a glide, play. The description waits for the end. */
  let moving = false;

  function request(): void {
    if (!frame && !broken) frame = requestAnimationFrame(render);
  }
  function render(): void {
    frame = 0;
    try {
      draw();
    } catch (error) {
      fail(error);
    }
    const change = pending;
    pending = null;
    if (change) setup.changed(change);
  }
  function draw(): void {
    const { figure } = core;
    shell.dataset.theme = isDark(options.theme) ? "dark" : "light";
    const { views, scale } = stage.draw(figure, lit, space?.painter ?? null);
    shell.style.setProperty("--scale", String(scale));
    layer.update(figure.handles, views, scale);
    const view = pencil && views[pencil.view];
    if (view) pencil.update(view, scale);
    rows.update();
    space?.update();
    readout.update(figure.readout);
    if (moving) return;
    const said = figure.description[lang];
    if (description.textContent !== said) description.textContent = said;
  }
  function fail(error: unknown): void {
    broken = true;
    console.error(`Straklatte, ${demo.id}:`, error);
    showProblems(problems, [WORDS.broken[lang]], WORDS.retry[lang]);
  }

  core.store.listen((change) => {
    moving = !change.committed;
    pending = { ...change, committed: change.committed || (pending?.committed ?? false) };
    if (change.committed && change.source === "user") announce(() => core.figure.description[lang], lang);
    request();
  });
  root.replaceChildren(shell, element("slot", {}));
  stage.measure();
  render();
  return {
    store: core.store,
    mover: core.mover,
    get figure() {
      return core.figure;
    },
    report: (found) =>
      showProblems(
        problems,
        found.map((one) => `${WORDS.unreadable[lang]}: ${one.param} = ${one.given}: ${one.problem[lang]}.`),
      ),
    light(names) {
      lit = names;
      for (const slider of rows.bar.querySelectorAll<HTMLElement>("[data-param]"))
        slider.classList.toggle("is-lit", names.has(slider.dataset.param!));
      request();
    },
    redraw: request,
    destroy() {
      core.mover.destroy();
      cancelAnimationFrame(frame);
      broken = true; // no drawing after the end
      space?.destroy();
      stage.destroy();
      root.replaceChildren(element("slot", {}));
    },
  };
}
