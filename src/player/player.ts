import { figureBox } from "../demo/box.ts";
import type { Demo } from "../demo/define.ts";
import { type Figure, figureOf } from "../demo/figure.ts";
import type { Param, State } from "../demo/param.ts";
import { type Problem, stateBetween } from "../demo/state.ts";
import { createAnimation } from "./animation.ts";
import { announce } from "./announcer.ts";
import { createMainSlider, createTool, type Tool } from "./bar.ts";
import { element } from "./element.ts";
import { type FrameOptions, isDark, reducedMotion } from "./frame.ts";
import { createHandleLayer } from "./handle-layer.ts";
import { createPanel } from "./panel.ts";
import type { BoundField } from "./panel-gui.ts";
import { createPencil } from "./pencil.ts";
import { listenToPointer } from "./pointer.ts";
import { showProblems } from "./problems.ts";
import { createReadout } from "./readout.ts";
import { arrowOf, commandOf, factorOf } from "./shortcuts.ts";
import { createStage } from "./stage.ts";
import { type Change, createStore, type Source, type Store } from "./store.ts";
import { addPanelStyles } from "./styles.ts";
import { WORDS } from "./words.ts";

/** One living figure. */
export interface Player {
  readonly store: Store;
  readonly figure: Figure;
  /** Takes over checked values; glides there if asked and allowed. */
  go(patch: State, options: { source: Source; glide?: boolean; commit?: boolean }): void;
  play(on: boolean): void;
  report(problems: readonly Problem[]): void;
  /** Marks lit up because their symbol is pointed at. */
  light(names: ReadonlySet<string>): void;
  /** The theme or the fonts have changed. */
  redraw(): void;
  hold(held: boolean): void;
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
  /** Called at most once a frame. */
  changed(change: Change): void;
}

const GLIDE = 0.3;

export function createPlayer(setup: PlayerSetup): Player {
  const { demo, root, options } = setup;
  const { lang } = options;
  const store = createStore(demo, setup.initial);
  const params = Object.entries(demo.params) as [string, Param<unknown>][];
  let figure = figureOf(demo, store.state);
  const current = () => {
    if (figure.state !== store.state) figure = figureOf(demo, store.state);
    return figure;
  };
  let lit: ReadonlySet<string> = new Set();

  // --- what is seen -----------------------------------------------------------------------------------
  const shell = element("div", {
    class: `shell controls-${options.controls}${setup.embedded ? " is-embedded" : ""}${options.still ? " is-still" : ""}`,
    role: "group",
    "aria-label": demo.title[lang],
    lang,
  });
  const box = figureBox(demo);
  shell.style.setProperty("--wide", String(box.wide));
  shell.style.setProperty("--narrow", String(box.narrow));
  const description = element("p", { class: "description", id: "description" });
  shell.setAttribute("aria-describedby", "description");
  const stage = createStage(options, () => request());
  const layer = createHandleLayer(lang);
  const readout = createReadout(lang, WORDS.readout[lang]);
  const problems = element("div", { class: "problems", role: "status" });
  if (!options.still) stage.root.append(layer.root);
  shell.append(stage.root);

  // --- changing the state -----------------------------------------------------------------------------
  const animation = createAnimation();
  const put = (id: string, value: unknown, commit: boolean, merge?: { kind: string; time: number }) => {
    stopMoving();
    store.set({ [id]: value }, { source: "user", commit, ...(merge ? { merge } : {}) });
  };
  const go: Player["go"] = (patch, { source, glide, commit }) => {
    animation.stop();
    if (!glide || reducedMotion()) return store.set(patch, { source, commit: commit !== false });
    const from = store.state;
    const to = { ...from, ...patch };
    animation.start(
      GLIDE,
      (share) => {
        const eased = share * share * (3 - 2 * share);
        const between = stateBetween(demo, from, to, eased);
        store.set(share < 1 ? between : patch, { source, commit: share === 1 && commit !== false });
      },
      () => request(),
    );
  };
  const animated = params.find(([, param]) => param.animate);
  const play = (on: boolean) => {
    if (!on) return stopMoving();
    if (!animated) return;
    const [id, param] = animated;
    const { from, to, seconds } = param.animate!;
    const now = store.state[id] as number;
    const start = now >= to ? from : now;
    animation.start(
      (seconds * (to - start)) / (to - from),
      (share) => store.set({ [id]: start + (to - start) * share }, { source: "user", commit: false }),
      () => store.set({}, { source: "user" }),
    );
    request();
  };
  /** Whatever moves by itself gives way to the reader's hand; where it stopped is a step of its own. */
  function stopMoving(): void {
    if (!animation.running) return;
    animation.stop();
    store.set({}, { source: "user" });
  }

  function travel(step: () => void): void {
    stopMoving();
    step();
  }

  // --- controls ---------------------------------------------------------------------------------------
  const bar = element("div", { class: "bar" });
  const tools = element("div", { class: "tools", role: "toolbar", "aria-label": demo.title[lang] });
  const mainParam = params.find(([, param]) => param.primary);
  const mainField = mainParam?.[1].fields(mainParam[0], store.state[mainParam[0]])[0];
  const slider =
    mainParam && mainField?.kind === "number"
      ? createMainSlider(mainField, lang, setup.embedded, (value, commit, event) => {
          const merge =
            event instanceof KeyboardEvent ? { kind: mainParam[0], time: event.timeStamp } : undefined;
          const [id, param] = mainParam;
          put(id, param.round(value), commit, merge);
        })
      : null;
  if (slider) bar.append(slider.root);
  const tool = (id: Parameters<typeof createTool>[0], name: string, run: () => void): Tool => {
    const made = createTool(id, name, () => {
      if (made.root.getAttribute("aria-disabled") !== "true") run();
    });
    tools.append(made.root);
    return made;
  };
  const playTool = animated ? tool("play", WORDS.play[lang], () => play(!animation.running)) : null;
  const drawn = params.find(([, param]) => param.drawnIn);
  const pencil = drawn
    ? createPencil(
        stage.root,
        lang,
        () => store.state[drawn[0]] as readonly (readonly number[])[],
        (points, commit) => put(drawn[0], drawn[1].round(points), commit),
      )
    : null;
  const pencilTool = pencil
    ? tool("pencil", WORDS.pencil[lang], () => {
        pencil.toggle(!pencil.on);
        request();
      })
    : null;
  if (pencil) layer.root.append(pencil.cross);
  const undoTool = tool("undo", WORDS.undo[lang], () => travel(store.undo));
  const redoTool = tool("redo", WORDS.redo[lang], () => travel(store.redo));
  tool("reset", WORDS.reset[lang], () => travel(() => store.reset(setup.own())));
  if (!setup.embedded) tool("fullscreen", WORDS.fullscreen[lang], () => void enterFullscreen());
  const valuesTool = tool("values", WORDS.values[lang], () => {
    panel.toggle();
    request();
  });
  bar.append(tools);

  const boundFields = (): BoundField[] =>
    params.flatMap(([param, declared]) =>
      declared.fields(param, store.state[param]).map((field) => ({ param, field })),
    );
  const panel = createPanel(
    {
      lang,
      fields: boundFields,
      actions: () =>
        params.flatMap(([id, param]) =>
          param.actions(store.state[id]).map((action) => ({
            label: action.label[lang],
            possible: action.value !== null,
            run: () => action.value !== null && put(id, action.value, true),
          })),
        ),
      put: (id, value, commit) => {
        const bound = boundFields().find(({ field }) => field.id === id);
        if (bound) put(bound.param, (bound.field.put as (next: typeof value) => unknown)(value), commit);
      },
      nudge: (direction) => nudge(layer.selected ?? current().handles[0]?.id, direction, 1),
    },
    () => addPanelStyles(root),
  );
  if (!options.still && options.controls !== "none") shell.append(bar);
  if (demo.readout) shell.append(readout.root);
  shell.append(problems);
  if (options.controls === "full" && !options.still) shell.append(panel.root);
  else valuesTool.root.remove();
  shell.append(description);

  async function enterFullscreen(): Promise<void> {
    try {
      if (document.fullscreenElement) await document.exitFullscreen();
      else await (root.host as HTMLElement).requestFullscreen();
    } catch {
      showProblems(problems, [WORDS.noFullscreen[lang]]);
    }
  }

  // --- mouse, touch, keys -----------------------------------------------------------------------------
  const handleById = (id: string) => current().handles.find((handle) => handle.id === id);
  listenToPointer(stage.root, layer, {
    where: (id) => {
      const handle = handleById(id);
      return handle ? stage.toStage(handle.view, handle.at) : null;
    },
    move: (id, x, y, commit) => {
      const handle = handleById(id);
      const to = handle && stage.toWorld(handle.view, x, y);
      if (to) put(handle.param, handle.put(to), commit);
    },
    cancel: () => store.cancel(),
    get drawing() {
      return pencil?.on ?? false;
    },
    draw: (x, y, phase) => pencil?.draw(x, y, phase),
  });
  function nudge(
    id: string | undefined,
    direction: readonly [number, number],
    factor: number,
    time?: number,
  ): void {
    const handle = id === undefined ? undefined : handleById(id);
    if (!handle) return;
    put(
      handle.param,
      handle.nudge(direction, factor),
      true,
      time === undefined ? undefined : { kind: handle.id, time },
    );
  }
  shell.addEventListener("keydown", (event) => {
    const focused = (event.target as HTMLElement).closest<HTMLElement>("[data-handle]");
    const typing = event.target instanceof HTMLInputElement && event.target.type === "text";
    const command = commandOf(event, focused !== null);
    if (command === "undo" && !typing) travel(store.undo);
    else if (command === "redo" && !typing) travel(store.redo);
    else if (command === "play") play(!animation.running);
    else if (command === "leave") {
      store.cancel();
      layer.select(null);
      (event.target as HTMLElement).blur();
      return;
    } else {
      const arrow = focused && arrowOf(event);
      if (!arrow) return;
      nudge(focused.dataset.handle, arrow, factorOf(event), event.timeStamp);
    }
    event.preventDefault();
  });

  // --- drawing ----------------------------------------------------------------------------------------
  let frame = 0;
  let pending: Change | null = null;
  let broken = false;
  function request(): void {
    if (!frame && !broken) frame = requestAnimationFrame(render);
  }
  function render(): void {
    frame = 0;
    if (broken) return;
    try {
      const shown = current();
      shell.dataset.theme = isDark(options.theme) ? "dark" : "light";
      const { views, scale } = stage.draw(demo, shown, lit);
      shell.style.setProperty("--scale", String(scale));
      layer.update(shown.handles, views, scale);
      if (mainParam && slider)
        slider.update(mainParam[1].fields(mainParam[0], store.state[mainParam[0]])[0]!);
      readout.update(shown.readout);
      const said = shown.description[lang];
      if (description.textContent !== said) description.textContent = said;
      const view = pencil && views[drawn![1].drawnIn!];
      if (view) pencil.update(view, scale);
      const moving = animation.running;
      playTool?.update({ icon: moving ? "pause" : "play", name: (moving ? WORDS.pause : WORDS.play)[lang] });
      pencilTool?.update({ pressed: pencil!.on });
      undoTool.update({ disabled: !store.canUndo });
      redoTool.update({ disabled: !store.canRedo });
      valuesTool.update({ pressed: panel.open });
      panel.update();
    } catch (error) {
      fail(error);
    }
    const change = pending;
    pending = null;
    if (change) setup.changed(change);
  }
  function fail(error: unknown): void {
    broken = true;
    console.error(`Straklatte, ${demo.id}:`, error);
    showProblems(problems, [WORDS.broken[lang]], WORDS.retry[lang]);
  }
  store.listen((change) => {
    pending = pending?.committed ? { ...change, committed: true } : change;
    if (change.committed && change.source === "user") announce(saidAfter(change.state), lang);
    request();
  });
  function saidAfter(state: State): string {
    return figureOf(demo, state).description[lang];
  }

  root.replaceChildren(shell, element("slot", {}));
  stage.measure();
  render();
  return {
    store,
    get figure() {
      return current();
    },
    go,
    play,
    report: (found) =>
      showProblems(
        problems,
        found.map((one) => `${WORDS.unreadable[lang]}: ${one.param} = ${one.given}: ${one.problem[lang]}.`),
      ),
    light(names) {
      lit = names;
      request();
    },
    redraw: request,
    hold: (held) => animation.hold(held),
    destroy() {
      animation.stop();
      cancelAnimationFrame(frame);
      stage.destroy();
      root.replaceChildren(element("slot", {}));
    },
  };
}
