import { expect, test } from "vitest";
import { compileLesson } from "../../src/build/compile-lesson.ts";
import { nearest, problemsText } from "../../src/build/problem.ts";
import { bench, compile, FIGURE, FIRST } from "./fixture.ts";

/** [what is wrong, the text, line within it from 0, what the message says, what the remedy says] */
const MISTAKES: readonly (readonly [string, string, number, RegExp, RegExp])[] = [
  ["demo misspelt", "::: demo seasaw {#fig}\nC.\n:::", 0, /unknown demo "seasaw"/, /did you mean "seesaw"/],
  [
    "parameter misspelt",
    "::: demo seesaw {#fig tt=1}\nC.\n:::",
    0,
    /no parameter "tt"/,
    /"t"\? there are: ends, t/,
  ],
  ["value out of range", "\n::: demo seesaw {#fig t=7}\nC.\n:::", 1, /t=7 cannot be read/, /number in 0 … 1/],
  [
    "value unreadable",
    "::: demo seesaw {#fig ends=0,0;x}\nC.\n:::",
    0,
    /ends=0,0;x cannot be read/,
    /points/,
  ],
  ["named state misspelt", "::: demo seesaw {#fig state=upp}\nC.\n:::", 0, /no state "upp"/, /"up"/],
  [
    "frame option misspelt",
    "::: demo seesaw {#fig controls=ful}\nC.\n:::",
    0,
    /controls=ful/,
    /full\|compact\|none/,
  ],
  ["figure without id", "::: demo seesaw\nC.\n:::", 0, /no id/, /\{#figure-id\}/],
  ["figure without caption", "::: demo seesaw {#fig}\n:::", 0, /no caption/, /what is to be seen/],
  ["id taken twice", `${FIGURE}\n## H {#fig-a}`, 4, /"fig-a" is taken already \(line 8\)/, /own id/],
  ["id in a wrong form", "## H {#Fig_A}", 0, /"Fig_A" is not of the form/, /small letters/],
  ["attribute twice", "::: demo seesaw {#fig t=1 t=0}\nC.\n:::", 0, /"t" stands twice/, /:::/],
  ["braces unreadable", '::: demo seesaw {#fig ="a"}\nC.\n:::', 0, /neither #id nor name=value/, /:::/],
  ["TeX, inline", "Eins\nzwei $\\frac{1}$ drei", 1, /TeX: .*frac/, /mend the formula: \\frac\{1\}/],
  ["TeX, unknown command", "$\\tied{p}{x}$", 0, /Undefined control sequence: \\tied/, /mend the formula/],
  ["TeX, displayed, third line", "$$\na\n+ \\nonsense\n$$", 2, /\\nonsense/, /mend/],
  ["TeX, displayed, one line", "\n$$ \\nonsense $$", 1, /\\nonsense/, /mend/],
  ["TeX, letter that is no TeX", "$\\text{a} ä$", 0, /Unicode/, /mend/],
  ["TeX in a list", "- a\n- b $\\nonsense$", 1, /\\nonsense/, /mend/],
  ["TeX in a caption", "::: demo seesaw {#fig}\nCap\n$\\nonsense$\n:::", 2, /\\nonsense/, /mend/],
  ["TeX in a footnote", "a[^1]\n\n[^1]: b $\\nonsense$", 2, /\\nonsense/, /mend/],
  ["TeX in a table", "| a |\n|---|\n| $\\nonsense$ |", 2, /\\nonsense/, /mend/],
  ["display not closed", "a\n\n$$\nx\n\nmore", 2, /"\$\$" is not closed/, /end the formula/],
  ["dollar left over", "costs 5 $ and", 0, /a "\$" that belongs to no formula/, /write "\\\$"/],
  ["display within a line", "so $$x$$ here", 0, /"\$"/, /lines of their own/],
  ["unknown block", "::: warning\nx\n:::", 0, /unknown block "warning"/, /there are: .*demo/],
  ["block not yet there", "::: exercise a\n:::", 0, /unknown block "exercise"/, /there are/],
  ["block not closed", "a\n\n::: note\nx", 2, /is not closed/, /":::"/],
  ["block closed twice", "::: note\nx\n:::\n:::", 3, /none is open/, /take the line away/],
  ["block without name", "::: {#a}\n:::", 0, /no name follows/, /write :::/],
  ["print outside of a demo", "::: print\nx\n:::", 0, /"print" stands outside of "demo"/, /inside demo/],
  [
    "print in a note in a demo",
    "::: demo seesaw {#f}\nC\n::: note\n::: print\nx\n:::\n:::\n:::",
    3,
    /outside/,
    /demo/,
  ],
  ["heading without id", "## Heading", 0, /"Heading" has no id/, /\{#an-id\}/],
  ["heading of level 1", "# Heading {#h}", 0, /level 1/, /front matter/],
  [
    "state link to no figure",
    `[[x]](demo:fig-b?t=1)\n\n${FIGURE}`,
    0,
    /no figure "fig-b"/,
    /did you mean "fig-a"/,
  ],
  [
    "state link, parameter",
    `${FIGURE}\na\n[[x]](demo:fig-a?u=1)`,
    5,
    /figure "fig-a": no parameter "u"/,
    /there are/,
  ],
  ["state link, value", `${FIGURE}\n[[x]](demo:fig-a?t=2)`, 4, /t=2 cannot be read/, /0 … 1/],
  ["state link, state", `${FIGURE}\n[[x]](demo:fig-a?state=down)`, 4, /no state "down" of seesaw/, /up/],
  ["state link, single brackets", `${FIGURE}\n[x](demo:fig-a?t=1)`, 4, /double brackets/, /\[\[words\]\]/],
  ["state link not parsed", `${FIGURE}\n[[x]](demo:fig-a?t=1 and)`, 4, /not understood/, /%20/],
  ["link to nowhere", "[x](other.html)", 0, /"other.html" leads nowhere/, /lesson:id#anchor/],
  ["link without protection", "[x](http://example.org/)", 0, /leads nowhere/, /https/],
  ["HTML", "a <b>x</b>", 0, /markup/, /HTML is not read/],
  ["image", "a ![x](y.png)", 0, /image/, /demo/],
  ["braces that belong to nothing", "word {#anchor} more", 0, /braces/, /headings/],
  ["code, no file", "::: code src/math/b.ts half\n:::", 0, /no file "src\/math\/b.ts"/, /root/],
  ["code, no function", "::: code src/math/a.ts third\n:::", 0, /nor a region "third"/, /#region/],
  ["code, no name", "::: code src/math/a.ts\n:::", 0, /missing/, /::: code <file>/],
];

test.each(MISTAKES)("%s: the build stops with line and remedy", (_, text, line, message, remedy) => {
  const { problems } = compile(text);
  expect(problems.map((one) => `${one.line}: ${one.message}`)).toEqual([expect.stringMatching(message)]);
  expect(problems[0]).toMatchObject({ file: "lessons/one/de.md", line: FIRST + line });
  expect(problems[0]!.remedy).toMatch(remedy);
});

test("all mistakes of a lesson are told at once, in the order of the lines", () => {
  const { problems } = compile("$\\nonsense$\n\n::: demo seasaw {#fig}\nC\n:::\n\n## H");
  expect(problemsText(problems).match(/^lessons\/one\/de\.md:\d+/gm)).toEqual([
    `lessons/one/de.md:${FIRST}`,
    `lessons/one/de.md:${FIRST + 2}`,
    `lessons/one/de.md:${FIRST + 6}`,
  ]);
  expect(problemsText(problems)).toMatch(/^3 problems in the lessons/);
});

test("the misspelt word is compared with what there is", () => {
  expect(nearest("bezir-curve", ["bezier-curve", "glyph"])).toBe("bezier-curve");
  expect(nearest("sphere", ["bezier-curve", "glyph"])).toBeNull();
});

/** [what is wrong, front matter, line, message] */
const FRONTS: readonly (readonly [string, string, number, RegExp])[] = [
  ["missing", "no front matter\n", 1, /front matter is missing/],
  ["not closed", "---\ntitle: a\n", 1, /front matter is missing/],
  ["no title", "---\nlead: a\nminutes: 1\ngoals:\n- a\n---\n", 1, /no "title"/],
  ["empty lead", "---\ntitle: a\nlead:\nminutes: 1\ngoals:\n- a\n---\n", 3, /no "lead"/],
  ["minutes in words", "---\ntitle: a\nlead: b\nminutes: ten\ngoals:\n- a\n---\n", 4, /no whole number: ten/],
  ["no goals", "---\ntitle: a\nlead: b\nminutes: 1\n---\n", 1, /no "goals"/],
  [
    "unknown entry",
    "---\ntitle: a\nleed: b\nlead: b\nminutes: 1\ngoals:\n- a\n---\n",
    3,
    /unknown entry "leed"/,
  ],
  [
    "entry twice",
    "---\ntitle: a\ntitle: b\nlead: b\nminutes: 1\ngoals:\n- a\n---\n",
    3,
    /"title" is given twice/,
  ],
  ["no entry at all", "---\ntitle: a\nlead: b\n!\nminutes: 1\ngoals:\n- a\n---\n", 4, /no "key: value": !/],
  [
    "addition",
    "---\ntitle: a\nlead: b\nminutes: 1\naddition: ja\ngoals:\n- a\n---\n",
    5,
    /neither yes nor no/,
  ],
];

test.each(FRONTS)("front matter %s: the build stops with line and remedy", (_, front, line, message) => {
  const { lesson, problems } = compileLesson({ id: "one", lang: "en", file: "a.md", source: front }, bench);
  expect(lesson).toBeNull();
  expect(problems.map((one) => [one.file, one.line, one.message])).toEqual([
    ["a.md", line, expect.stringMatching(message)],
  ]);
  expect(problems[0]!.remedy).not.toBe("");
});

test("TeX in the front matter is read, and its mistakes have its lines", () => {
  const front = "---\ntitle: a\nlead: so $\\nonsense$\nminutes: 1\ngoals:\n- a\n- $\\nonsense$\n---\n";
  expect(compile("", { front }).problems.map(({ line }) => line)).toEqual([3, 7]);
});
