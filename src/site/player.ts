import type { CurveDemo } from "../player/index.ts";

let coming: Promise<void> | undefined;

/** Loads the player and the registry of demos, once, and defines `<curve-demo>`. One retry. */
export function loadPlayer(): Promise<void> {
  coming ??= load().catch(load);
  return coming;
}

async function load(): Promise<void> {
  const [{ defineCurveDemo }, { demos }] = await Promise.all([
    import("../player/index.ts"),
    import("../demos/index.ts"),
  ]);
  defineCurveDemo(demos);
}

/** The demo of a figure, alive. */
export async function demoOf(figure: Element): Promise<CurveDemo | null> {
  const demo = figure.querySelector<CurveDemo>("curve-demo");
  if (demo) await loadPlayer();
  return demo;
}

const FAILED = {
  de: "Diese Figur konnte nicht geladen werden; das Standbild bleibt. Laden Sie die Seite neu, um es noch einmal zu versuchen.",
  en: "This figure could not be loaded; the still picture stays. Reload the page to try again.",
};

/** Loads the player as soon as a figure comes near; a page that is only read in its first part needs none. */
export function loadPlayerNear(demos: readonly Element[]): void {
  const near = new IntersectionObserver(
    (entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      near.disconnect();
      loadPlayer().catch((error: unknown) => {
        console.error("Straklatte:", error);
        for (const demo of demos)
          demo.after(note(FAILED[document.documentElement.lang === "en" ? "en" : "de"]));
      });
    },
    { rootMargin: "800px" },
  );
  for (const demo of demos) near.observe(demo);
}

function note(text: string): HTMLElement {
  const paragraph = document.createElement("p");
  paragraph.className = "failure";
  paragraph.textContent = text;
  return paragraph;
}
