import type { CurveDemo } from "../player/index.ts";

/** A symbol of a formula and what it stands for: a figure, and the name of something in it. */
export interface Tie {
  readonly figure: string;
  readonly name: string;
}

/** Lights symbols and marks that belong together, whichever of them is pointed at. */
export interface Lighting {
  /** These are pointed at, and nothing else. */
  point(ties: readonly Tie[]): void;
}

/** `figure/points.1` of an attribute. */
export function readTie(text: string): Tie {
  const cut = text.indexOf("/");
  return { figure: text.slice(0, cut), name: text.slice(cut + 1) };
}

/** The living figure of an id; null while it sleeps. */
export function livingDemo(figure: string): CurveDemo | null {
  const demo = document.getElementById(figure)?.querySelector<CurveDemo>("curve-demo[data-ready]");
  return demo ?? null;
}

/** The names in a figure that a tie means: `points.*` is all points, `points.n-1` the last but one. */
export function meant(name: string, all: readonly string[]): readonly string[] {
  const segments = name.split(".");
  // A name of its own may be n, the normal.
  const last = segments.length > 1 ? /^n(?:-(\d+))?$/.exec(segments.at(-1)!) : null;
  if (!last && !segments.includes("*")) return [name];
  const like = all.filter((one) => {
    const parts = one.split(".");
    const fits = (segment: string, k: number) =>
      segment === parts[k] ||
      ((segment === "*" || (last && k === segments.length - 1)) && /^\d+$/.test(parts[k]!));
    return parts.length === segments.length && segments.every(fits);
  });
  if (!last) return like;
  const index = (one: string) => Number(one.split(".").at(-1));
  const wanted = Math.max(...like.map(index)) - Number(last[1] ?? 0);
  return like.filter((one) => index(one) === wanted);
}

export function lighting(main: HTMLElement): Lighting {
  const symbols = new Map<string, { element: HTMLElement; name: string }[]>();
  for (const element of main.querySelectorAll<HTMLElement>("[data-tie]")) {
    const { figure, name } = readTie(element.dataset.tie!);
    const list = symbols.get(figure) ?? [];
    list.push({ element, name });
    symbols.set(figure, list);
  }
  /** Lights the symbols of a figure that mean one of the names. */
  const lightSymbols = (figure: string, names: ReadonlySet<string>, all: readonly string[]) => {
    for (const { element, name } of symbols.get(figure) ?? []) {
      const on = names.size > 0 && meant(name, all).some((one) => names.has(one));
      if (on !== element.classList.contains("is-lit")) element.classList.toggle("is-lit", on);
    }
  };
  let pointed: readonly string[] = [];
  main.addEventListener("curve-demo-point", (event) => {
    const demo = event.target as CurveDemo;
    const { names } = (event as CustomEvent<{ names: readonly string[] }>).detail;
    lightSymbols(demo.closest("figure")?.id ?? "", new Set(names), demo.names);
  });
  return {
    point(ties) {
      const figures = new Map<string, Set<string>>(pointed.map((id) => [id, new Set()]));
      pointed = [...new Set(ties.map(({ figure }) => figure))];
      for (const { figure, name } of ties) {
        const all = livingDemo(figure)?.names ?? [];
        const names = figures.get(figure) ?? new Set();
        for (const one of all.length > 0 ? meant(name, all) : [name]) names.add(one);
        figures.set(figure, names);
      }
      for (const [figure, names] of figures) {
        const demo = livingDemo(figure);
        demo?.light(names);
        lightSymbols(figure, names, demo?.names ?? [...names]);
      }
    },
  };
}
