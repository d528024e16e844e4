import { describe, expect, test } from "vitest";
import { checkLinks, checkTwins, missingTwins } from "../../src/build/check-lessons.ts";
import { makeCourse } from "../../src/build/course.ts";
import { bench, compile, FIGURE, FIRST } from "./fixture.ts";

const twins = (de: string, en: string, front?: { de: string; en: string }) =>
  checkTwins(
    compile(de, front ? { front: front.de } : {}).lesson,
    compile(en, { lang: "en", ...(front ? { front: front.en } : {}) }).lesson,
  );

const BASE = `## A {#a}\n\nText.\n\n${FIGURE}\n$$\nx\n$$\n\n::: note\nn\n:::\n`;

describe("the two languages of a lesson", () => {
  test("agree when headings, figures, formulas and blocks do, whatever the words", () => {
    expect(twins(BASE, BASE.replace("Text.", "Words,\nmore of them.").replace("## A", "## B"))).toEqual([]);
  });

  test.each([
    ["a heading's id", "{#a}", "{#b}", FIRST, /heading ## \{#a\}.*en\.md:8 has: heading ## \{#b\}/],
    ["a heading's level", "## A", "### A", FIRST, /heading ##/],
    ["a demo's state", "{#fig-a}", "{#fig-a t=1}", FIRST + 4, /demo seesaw #fig-a.*demo seesaw #fig-a t=1/],
    ["a figure's id", "{#fig-a}", "{#fig-b}", FIRST + 4, /#fig-a.*#fig-b/],
    ["a formula", "$$\nx\n$$\n", "", FIRST + 8, /displayed formula.*has: note/],
    ["a block's kind", "::: note", "::: example", FIRST + 12, /note.*has: example/],
    ["the last block", "::: note\nn\n:::\n", "", FIRST + 12, /note.*en\.md ends before/],
  ])("differ in %s", (_, old, other, line, message) => {
    expect(twins(BASE, BASE.replace(old, other))).toEqual([
      expect.objectContaining({
        file: "lessons/one/de.md",
        line,
        message: expect.stringMatching(message),
        remedy: expect.stringContaining("same headings"),
      }),
    ]);
  });

  test("what only the English text has is told there", () => {
    const [problem] = twins(BASE, `${BASE}\n$$\ny\n$$\n`);
    expect(problem).toMatchObject({ file: "lessons/one/en.md", line: FIRST + 16 });
    expect(problem!.message).toMatch(/displayed formula.*lessons\/one\/de.md ends before/);
  });

  test("a state link may move within its section, but must be there", () => {
    const link = (t: number) => `[[x]](demo:fig-a?t=${t})`;
    const de = `${FIGURE}\n## A {#a}\n\n${link(0)} und ${link(1)}\n`;
    expect(twins(de, `${FIGURE}\n## A {#a}\n\n${link(1)}\nand ${link(0)}\n`)).toEqual([]);
    const problems = twins(de, `${FIGURE}\n## A {#a}\n\n${link(0)} and ${link(0)}\n`);
    expect(problems.map(({ file, line, message }) => [file, line, message])).toEqual([
      ["lessons/one/de.md", FIRST + 6, expect.stringContaining("demo:fig-a?t=1 (section #a) has no twin")],
      ["lessons/one/en.md", FIRST + 6, expect.stringContaining("demo:fig-a?t=0 (section #a) has no twin")],
    ]);
  });

  test("agree in the figures of the front matter", () => {
    const front = (minutes: number) => `---\ntitle: a\nlead: b\nminutes: ${minutes}\ngoals:\n- a\n---\n`;
    expect(twins(BASE, BASE, { de: front(10), en: front(20) })).toEqual([
      expect.objectContaining({
        file: "lessons/one/en.md",
        message: expect.stringContaining("front matter differs"),
      }),
    ]);
  });

  test("are both there", () => {
    const files = [
      { id: "a", lang: "de" },
      { id: "a", lang: "en" },
      { id: "b", lang: "en" },
    ];
    expect(missingTwins(files)).toEqual([
      expect.objectContaining({ file: "lessons/b/de.md", message: 'the lesson "b" has no de.md' }),
    ]);
  });
});

describe("links between lessons", () => {
  const b = compile("## B {#b}", { id: "b" }).lesson;
  const check = (text: string) => checkLinks([compile(text).lesson, b], ["one", "b", "later"]);

  test("lead to lessons and anchors that exist", () => {
    expect(check("## A {#a}\n\n[x](#a) [y](lesson:b) [z](lesson:b#b)")).toEqual([]);
  });

  test.each([
    ["[x](#nowhere)", /no anchor "nowhere" in lessons\/one\/de.md/],
    ["[x](lesson:c)", /no lesson "c"/],
    ["[x](lesson:later)", /no lesson "later"/],
    ["[x](lesson:b#c)", /no anchor "c" in lessons\/b\/de.md/],
    ["::: note\n[x](#nowhere)\n:::", /no anchor "nowhere"/],
  ])("%s is a problem", (text, message) => {
    expect(check(text).map((one) => one.message)).toEqual([expect.stringMatching(message)]);
  });

  test("a lesson may build on one that is not written yet, but not on one that never will be", () => {
    const front = (id: string) =>
      `---\ntitle: a\nlead: b\nminutes: 1\ngoals:\n- a\nprerequisites:\n- ${id}\n---\n`;
    const withFront = (id: string) =>
      checkLinks([compile("", { front: front(id) }).lesson], ["one", "later"]);
    expect(withFront("later")).toEqual([]);
    expect(withFront("latter")).toEqual([
      expect.objectContaining({ line: 8, message: expect.stringContaining('no lesson "latter"') }),
    ]);
  });
});

describe("the course", () => {
  const source = "---\ntitle: a\nlead: b\nminutes: 1\ngoals:\n- a\n---\n";
  const file = (id: string, lang: "de" | "en") => ({ id, lang, file: `lessons/${id}/${lang}.md`, source });
  const parts = [{ title: { de: "Teil", en: "Part" }, lessons: ["b", "a"] }];

  test("has the lessons that exist, in its own order", () => {
    const files = [file("a", "de"), file("a", "en"), file("b", "de"), file("b", "en")];
    const { lessons, problems } = makeCourse(files, parts, bench);
    expect(problems).toEqual([]);
    expect(lessons.filter(({ lang }) => lang === "en").map(({ id }) => id)).toEqual(["b", "a"]);
  });

  test("has a place for each lesson", () => {
    const { problems } = makeCourse([file("c", "de"), file("c", "en")], parts, bench);
    expect(problems.map(({ message }) => message)).toContain('the lesson "c" has no place in lessons/toc.ts');
  });
});
