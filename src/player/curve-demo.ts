import type { Demo } from "../demo/define.ts";
import { withGuess } from "../demo/guess.ts";
import type { State } from "../demo/param.ts";
import { readQuery, splitQuery, writeQuery } from "../demo/query.ts";
import { changed, checkValues, initialState, type Problem, readValues, sameState } from "../demo/state.ts";
import { element } from "./element.ts";
import { connectEmbed, type Embed } from "./embed.ts";
import { frameOptions } from "./frame.ts";
import { watchTheme } from "./palette.ts";
import { createPlayer, type Player, type PlayerSetup } from "./player.ts";
import { printTwin } from "./print-twin.ts";
import { showProblems } from "./problems.ts";
import type { Change } from "./store.ts";
import { adoptStyles } from "./styles.ts";
import { WORDS } from "./words.ts";

/** The demos a page knows, by id. */
export type Registry = Readonly<Record<string, () => Promise<{ default: Demo }>>>;

/** Attributes that speak to the frame; a change of one builds the figure anew, with its state kept. */
const FRAME = new Set(["lang", "theme", "controls", "autoplay", "still", "dpr"]);
/** Attributes that say nothing to a demo. */
const PLAIN =
  /^(demo|state|seed|solutions|tries|camera|id|class|style|slot|title|hidden|tabindex|role|aria-.*|data-.*|on.*)$/;

export interface GoOptions {
  /** Glide there, as links in the text do. */
  readonly glide?: boolean;
  readonly commit?: boolean;
}

/**
 * `<curve-demo demo="…">`: a figure that comes to life when it comes near. Its light child, the still
 * picture, stays for those who print and wherever life does not come.
 */
export class CurveDemo extends HTMLElement {
  static registry: Registry = {};
  /** In an embed page the query counts like attributes, and messages are answered. */
  static embedded = false;

  #demo: Demo | undefined;
  #player: Player | undefined;
  #inSpace: PlayerSetup["inSpace"];
  #own: State = {};
  #near: IntersectionObserver | undefined;
  #attributes: MutationObserver | undefined;
  #unwatch: (() => void)[] = [];
  #embed: Embed | undefined;
  #waiting: (() => void)[] = [];
  #isNear = true;

  connectedCallback(): void {
    if (CurveDemo.embedded) {
      void this.#wake();
      return;
    }
    this.#near = new IntersectionObserver(
      (entries) => {
        this.#isNear = entries.at(-1)!.isIntersecting;
        if (this.#isNear && !this.#player) void this.#wake();
        this.#hold();
      },
      { rootMargin: "600px" },
    );
    this.#near.observe(this);
  }

  disconnectedCallback(): void {
    this.#near?.disconnect();
    this.#sleep();
  }

  /** The state as a plain object; a copy, so that nothing outside can change the figure unseen. */
  get state(): State {
    return structuredClone(this.#player?.store.state ?? this.#own) as State;
  }
  set state(next: State) {
    this.setState(next);
  }

  /** Takes over values; what cannot be taken is reported in the figure, the rest counts. */
  setState(partial: Readonly<Record<string, unknown>>, options: GoOptions = {}): void {
    this.#whenAwake((player, demo) => {
      const { patch, problems } = checkValues(demo, Object(partial));
      player.report(problems);
      player.mover.go(patch, { source: "program", ...options });
    });
  }

  /** Takes over the values of a query such as `t=0.5&points=…`, or a named state: `state=half`. */
  applyQuery(query: string, options: GoOptions = {}): void {
    this.#whenAwake((player, demo) => {
      const { patch, problems } = this.#readWithNames(demo, query);
      player.report(problems);
      player.mover.go(patch, { source: "user", ...options });
    });
  }

  /** What differs from the figure's own initial state, in the notation of URLs. */
  get query(): string {
    return this.#demo && this.#player ? writeQuery(this.#demo, this.#player.store.state, this.#own) : "";
  }

  /** What differs from the demo's declaration: the query that an embed of this state needs. */
  get embedQuery(): string {
    return this.#demo && this.#player
      ? writeQuery(this.#demo, this.#player.store.state, initialState(this.#demo))
      : "";
  }

  /** Whether the figure shows what a query asks for. */
  inState(query: string): boolean {
    if (!this.#demo || !this.#player) return false;
    const { patch } = this.#readWithNames(this.#demo, query);
    const state = this.#player.store.state;
    return Object.keys(patch).length > 0 && sameState(this.#demo, changed(this.#demo, state, patch), state);
  }

  play(on = true): void {
    this.#whenAwake((player) => player.mover.play(on));
  }

  /** What the figure computes in its present state, and the state itself: numbers, points, lists by name. */
  get values(): Readonly<Record<string, unknown>> {
    return this.#player ? { ...this.#player.store.state, ...this.#player.figure.values } : {};
  }

  /** Names of all that can be lit up now: marks, handles, parameters. */
  get names(): readonly string[] {
    if (!this.#player || !this.#demo) return [];
    const { scene, handles } = this.#player.figure;
    const marks = Object.values(scene).flatMap((view) => view.flatMap(({ name }) => name ?? []));
    return [...new Set([...marks, ...handles.map(({ id }) => id), ...Object.keys(this.#demo.params)])];
  }

  /** Lights up the marks of these names, as pointing at their symbols does. */
  light(names: Iterable<string>): void {
    this.#player?.light(new Set(names));
  }

  /** Brings the figure to life now, wherever it is. */
  wake(): void {
    if (!this.#player) void this.#wake();
  }

  #whenAwake(run: (player: Player, demo: Demo) => void): void {
    if (this.#player && this.#demo) {
      run(this.#player, this.#demo);
      return;
    }
    this.#waiting.push(() => this.#player && this.#demo && run(this.#player, this.#demo));
    this.wake();
  }

  #readWithNames(demo: Demo, query: string): { patch: State; problems: readonly Problem[] } {
    const { patch, problems } = readQuery(demo, query);
    const name = splitQuery(query).find(([id]) => id === "state")?.[1];
    const named = name === undefined ? {} : demo.states?.[name];
    if (named) return { patch: { ...named, ...patch }, problems };
    const list = Object.keys(demo.states ?? {}).join(", ") || "–";
    const problem = { de: `Zustände sind: ${list}`, en: `states are: ${list}` };
    return { patch, problems: [...problems, { param: "state", given: name!, problem }] };
  }

  #loading = false;
  async #wake(): Promise<void> {
    if (this.#loading || this.#player) return;
    this.#loading = true;
    const id = this.getAttribute("demo") ?? "";
    const load = Object.hasOwn(CurveDemo.registry, id) ? CurveDemo.registry[id] : undefined;
    try {
      if (!load) return this.#sayOnly((lang) => `${WORDS.noDemo[lang]} ${id}`);
      const demo = withGuess((await load().catch(load)).default, this.getAttribute("data-guess"));
      // Looking around in space is loaded with the first figure that does.
      if (Object.values(demo.views).some((view) => view.space)) {
        const inSpace = () => import("./space-controls.ts");
        this.#inSpace ??= (await inSpace().catch(inSpace)).createSpaceControls;
      }
      this.#demo = demo;
      if (this.isConnected) this.#come(this.#demo);
    } catch (error) {
      console.error(`Straklatte, ${id}:`, error);
      this.#sayOnly((lang) => WORDS.notLoaded[lang], true);
    } finally {
      this.#loading = false;
    }
  }

  /** Builds the living figure; the still picture gives way to it within the same frame. */
  #come(demo: Demo, keep?: State): void {
    const { problems } = this.#readOwn(demo);
    const root = this.shadowRoot ?? this.attachShadow({ mode: "open" });
    adoptStyles(root);
    const player = createPlayer({
      demo,
      root,
      initial: keep ?? this.#own,
      own: () => this.#own,
      options: frameOptions((name) => this.#ask(name), this),
      embedded: CurveDemo.embedded,
      ...(this.#inSpace ? { inSpace: this.#inSpace } : {}),
      changed: (change) => this.#tell(change),
      pointed: (names) =>
        this.dispatchEvent(new CustomEvent("curve-demo-point", { detail: { names }, bubbles: true })),
    });
    this.#player = player;
    if (problems.length > 0) player.report(problems);
    this.#watch(demo, player);
    if (CurveDemo.embedded) this.#embed ??= connectEmbed(this, demo);
    if (!keep) {
      if (this.#isOn("autoplay") && !matchMedia("(prefers-reduced-motion: reduce)").matches)
        player.mover.play(true);
      this.setAttribute("data-ready", "");
      this.#embed?.ready();
      this.dispatchEvent(new CustomEvent("curve-demo-ready", { bubbles: true }));
    }
    for (const run of this.#waiting.splice(0)) run();
  }

  #watch(demo: Demo, player: Player): void {
    for (const stop of this.#unwatch.splice(0)) stop();
    this.#unwatch.push(
      watchTheme(() => player.redraw()),
      printTwin(this, demo, () => ({
        figure: player.figure,
        lang: frameOptions((name) => this.#ask(name), this).lang,
      })),
    );
    document.fonts.addEventListener("loadingdone", player.redraw);
    this.#unwatch.push(() => document.fonts.removeEventListener("loadingdone", player.redraw));
    const hold = () => this.#hold();
    document.addEventListener("visibilitychange", hold);
    this.#unwatch.push(() => document.removeEventListener("visibilitychange", hold));
    this.#attributes ??= new MutationObserver((records) => this.#attributesChanged(records));
    this.#attributes.observe(this, { attributes: true });
  }

  /** Nothing moves where nobody can see it. */
  #hold(): void {
    this.#player?.mover.hold(document.hidden || !this.#isNear);
  }

  #attributesChanged(records: readonly MutationRecord[]): void {
    const names = new Set(records.map((record) => record.attributeName ?? ""));
    const demo = this.#demo;
    if (!demo || !this.#player) return;
    if (names.has("demo")) {
      this.#sleep();
      void this.#wake();
      return;
    }
    if ([...names].some((name) => FRAME.has(name))) {
      const state = this.#player.store.state;
      this.#player.destroy();
      this.#come(demo, state);
      return;
    }
    const ids = [...names].filter((name) => Object.hasOwn(demo.params, name));
    if (ids.length === 0 && ![...names].some((name) => !PLAIN.test(name))) return;
    const { problems } = this.#readOwn(demo);
    this.#player.report(problems);
    this.#player.mover.go(Object.fromEntries(ids.map((id) => [id, this.#own[id]])), { source: "program" });
  }

  /** The figure's own initial state: the declaration, a named state, the attributes, in an embed the query. */
  #readOwn(demo: Demo): { problems: readonly Problem[] } {
    const attributes = [...this.attributes]
      .filter(({ name }) => Object.hasOwn(demo.params, name) || (!PLAIN.test(name) && !FRAME.has(name)))
      .map(({ name, value }) => [name, value] as const);
    const found = readValues(demo, attributes);
    const named = this.getAttribute("state");
    const fromState = named
      ? this.#readWithNames(demo, `state=${encodeURIComponent(named)}`)
      : { patch: {}, problems: [] };
    const query = CurveDemo.embedded
      ? this.#readWithNames(demo, location.search)
      : { patch: {}, problems: [] };
    this.#own = changed(demo, initialState(demo), { ...fromState.patch, ...found.patch, ...query.patch });
    return { problems: [...fromState.problems, ...found.problems, ...query.problems] };
  }

  #ask(name: string): string | null {
    const query = CurveDemo.embedded
      ? splitQuery(location.search).find(([id]) => id === name)?.[1]
      : undefined;
    return query ?? this.getAttribute(name);
  }

  #isOn(name: string): boolean {
    const value = this.#ask(name);
    return value === "1" || value === "";
  }

  #tell(change: Change): void {
    const { source, committed } = change;
    const detail = { state: this.state, source, committed };
    this.dispatchEvent(new CustomEvent("statechange", { detail, bubbles: true }));
    this.#embed?.changed(change);
  }

  #sayOnly(text: (lang: "de" | "en") => string, retry = false): void {
    const { lang } = frameOptions((name) => this.#ask(name), this);
    const root = this.shadowRoot ?? this.attachShadow({ mode: "open" });
    adoptStyles(root);
    const problems = element("div", { class: "problems", role: "status" });
    showProblems(problems, [text(lang)], retry ? WORDS.retry[lang] : undefined);
    root.replaceChildren(
      element("slot", { class: "shown" }),
      element("div", { class: "shell is-note" }, problems),
    );
    this.#embed?.failed(text(lang));
  }

  #sleep(): void {
    this.#attributes?.disconnect();
    for (const stop of this.#unwatch.splice(0)) stop();
    this.#player?.destroy();
    this.#player = undefined;
    this.removeAttribute("data-ready");
  }
}
