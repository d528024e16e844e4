import { compileLesson, type Lesson, type Workbench } from "../../src/build/compile-lesson.ts";
import type { Problem } from "../../src/build/problem.ts";
import { defineDemo, number, points } from "../../src/demo/index.ts";
import type { Lang } from "../../src/words/words.ts";
import { same } from "../../src/words/words.ts";

/** A demo that only these tests know. */
const seesaw = defineDemo({
  id: "seesaw",
  title: { de: "Wippe", en: "Seesaw" },
  params: {
    t: number({ initial: 0.5, min: 0, max: 1, step: 0.1, label: same("t") }),
    ends: points({
      initial: [
        [0, 0],
        [1, 1],
      ],
      label: same("ends"),
    }),
  },
  views: { plane: { label: same("plane"), x: [0, 1], y: [0, 1], height: 0.5 } },
  values: ({ t }) => ({ t }),
  scene: () => ({ plane: [] }),
  describe: ({ t }) => same(`t = ${t}`),
  states: { up: { t: 1 } },
});

export const bench: Workbench = {
  demos: new Map([["seesaw", seesaw]]),
  still: (_, state) => ({
    box: { wide: 0.5, narrow: 0.7, belowWide: 52, belowNarrow: 100 },
    svg: `<svg data-state="${JSON.stringify(state).replaceAll('"', "'")}"></svg>`,
  }),
  identities: new Map([["sum", "a + b = b + a"]]),
  readSource: (path) =>
    path === "src/math/a.ts" ? "export function half(x: number) {\n  return x / 2;\n}\n" : null,
};

const FRONT = `---
title: Title
lead: Lead
minutes: 10
goals:
- one
---
`;

/** The first line of what is handed to `lesson`, in the file. */
export const FIRST = FRONT.split("\n").length;

/** Compiles a text below a front matter that is in order. */
export function compile(
  text: string,
  { lang = "de", id = "one", front = FRONT }: { lang?: Lang; id?: string; front?: string } = {},
): { lesson: Lesson; problems: readonly Problem[] } {
  const file = `lessons/${id}/${lang}.md`;
  const { lesson, problems } = compileLesson({ id, lang, file, source: front + text }, bench);
  if (!lesson) throw new Error(`no lesson: ${JSON.stringify(problems)}`);
  return { lesson, problems };
}

/** The markup of a text that has no problems. */
export function html(text: string, lang: Lang = "de"): string {
  const { lesson, problems } = compile(text, { lang });
  if (problems.length > 0) throw new Error(JSON.stringify(problems, null, 1));
  return lesson.body;
}

export const FIGURE = "::: demo seesaw {#fig-a}\nCaption.\n:::\n";
