import { describe, expect, test } from "vitest";
import { compileLesson, type Workbench } from "../../src/build/compile-lesson.ts";
import bezierCurve from "../../src/demos/bezier-curve.ts";
import bezierPatch from "../../src/demos/bezier-patch.ts";
import deCasteljauDemo from "../../src/demos/de-casteljau.ts";
import type { Lang } from "../../src/words/words.ts";
import { FIRST, bench as other } from "./fixture.ts";

const bench: Workbench = {
  ...other,
  demos: new Map([
    ["bezier-curve", bezierCurve],
    ["bezier-patch", bezierPatch],
    ["de-casteljau", deCasteljauDemo],
  ]),
};
const FRONT = "---\ntitle: Title\nlead: Lead\nminutes: 10\ngoals:\n- one\n---\n";
const CURVE = "::: demo bezier-curve {#fig-a t=0.4}\nA.\n:::\n";
const LEVELS = "::: demo de-casteljau {#fig-b t=0.4}\nB.\n:::\n";
/** Figures that show all that the glossary names, in a section of their own. */
const SHOWN = `\n## Z {#z}\n\n${CURVE.replace("fig-a", "fig-y")}\n${LEVELS.replace("fig-b", "fig-z")}`;
const SYMBOLS =
  "::: symbols\n- $c_i$ `points.i`: point\n- $B_i^n$ `weights.i`: weight\n- $b_i^r$ `b.r.i`: step\n- $p(t)$ `p`: curve point\n- $t$ `t`: parameter\n- $n$: degree\n:::\n";

function compile(text: string, lang: Lang = "en") {
  const { lesson, problems } = compileLesson(
    { id: "one", lang, file: "one.md", source: FRONT + text },
    bench,
  );
  return { body: lesson?.body ?? "", lesson: lesson!, problems };
}
function html(text: string, lang: Lang = "en"): string {
  const { body, problems } = compile(text, lang);
  expect(problems).toEqual([]);
  return body;
}
/** What the formulas' symbols are tied to, in order. */
const ties = (markup: string) => [...markup.matchAll(/data-tie="([^"]*)"/g)].map(([, tie]) => tie);
const eyes = (markup: string) => markup.replace(/<math.*?<\/math>/gs, "").replace(/<[^>]*>/g, "");

describe("ties written by hand", () => {
  test("mark a symbol with figure, name and index, for the eyes only", () => {
    const markup = html(`${CURVE}\n$\\tie{points.1}{c_1}$`);
    expect(markup).toMatch(/<span class="enclosing" data-tie="fig-a\/points.1" data-index="1">/);
    expect(markup).toMatch(/<annotation encoding="application\/x-tex">c_1<\/annotation>/);
  });

  test("take the figure before, in the same section; else the next one; or the one that is named", () => {
    expect(ties(html(`${CURVE}\n${LEVELS}\n$\\tie{p}{p}$`))).toEqual(["fig-b/p"]);
    expect(ties(html(`$\\tie{p}{p}$\n\n${CURVE}\n${LEVELS}`))).toEqual(["fig-a/p"]);
    expect(ties(html(`${CURVE}\n## S {#s}\n\n$\\tie{p}{p}$\n\n${LEVELS}`))).toEqual(["fig-b/p"]);
    expect(ties(html(`${CURVE}\n${LEVELS}\n## S {#s}\n\n$\\tie{fig-a/p}{p}$`))).toEqual(["fig-a/p"]);
    const named = `${CURVE}\n${LEVELS}\n::: notation {figure=fig-a}\n$$\n\\tie{p}{p}\n$$\n:::\n`;
    expect(ties(html(named))).toEqual(["fig-a/p"]);
  });

  test("know marks, handles, parameters and computed values, all of them or the last", () => {
    for (const name of ["curve", "points.3", "t", "weights.2", "degree", "points.*", "points.n"])
      expect(ties(html(`${CURVE}\n$\\tie{${name}}{x}$`))).toEqual([`fig-a/${name}`]);
  });

  test("know marks that only a named state or a link of the text brings", () => {
    expect(ties(html(`${CURVE}\n$\\tie{derivative-0}{v}$`))).toEqual(["fig-a/derivative-0"]);
    const link = `${CURVE}\n$\\tie{points.4}{c_4}$ [[five]](demo:fig-a?points=0,0;1,1;2,2;3,1;4,0)`;
    expect(ties(html(link))).toEqual(["fig-a/points.4"]);
  });

  const BROKEN: readonly (readonly [string, string, RegExp, RegExp])[] = [
    ["mark", `${CURVE}\n$\\tie{curv}{x}$`, /"fig-a" has no "curv"/, /did you mean "curve"/],
    ["handle", `${CURVE}\n$\\tie{points.9}{x}$`, /no "points.9"/, /points\.0/],
    ["parameter", `${CURVE}\n$\\tie{tt}{x}$`, /no "tt"/, /did you mean "t"/],
    ["figure", `${CURVE}\n$\\tie{fig-c/p}{x}$`, /there is no "fig-c"/, /fig-a/],
    ["no figure", "\n\n\n\n$\\tie{p}{x}$", /tied to no figure/, /there are none/],
    ["arguments", `${CURVE}\n$\\tie{p} x$`, /not its two arguments/, /\\tie\{name\}\{x\}/],
    ["own data", `${CURVE}\n$\\htmlData{a=b}{x}$`, /not for authors/, /\\tie/],
    ["live name", `${CURVE}\n$\\live{weight.0}{0.0}$`, /computes no number "weight.0"/, /weights/],
    ["live picture", `${CURVE}\n$\\live{t}{x}$`, /"x" is no picture/, /0\.00/],
    [
      "glossary",
      `${CURVE}\n::: symbols\n- $c_i$ \`point.i\`: x\n:::`,
      /no figure .* shows "point.i"/,
      /points/,
    ],
    [
      "glossary's form",
      `${CURVE}\n::: symbols\n- c is a point\n:::`,
      /cannot read the symbol/,
      /write - \$c_i\$/,
    ],
  ];
  test.each(BROKEN)("a broken one stops the build: %s", (_, text, message, remedy) => {
    const { problems } = compile(text);
    expect(problems.map((one) => one.message)).toEqual([expect.stringMatching(message)]);
    expect(problems[0]!.remedy).toMatch(remedy);
    expect(problems[0]).toMatchObject({
      file: "one.md",
      line: FIRST + (text.includes("c is a point") ? 5 : 4),
    });
  });
});

describe("the glossary", () => {
  const tied = (tex: string, figure = CURVE) =>
    ties(
      /<p>(?:(?!<\/p>).)*<\/p>\n<div class="block symbols"/s.exec(
        html(`${figure}\n$${tex}$\n\n${SYMBOLS}${SHOWN}`),
      )![0],
    );

  test("ties its symbols wherever they stand in a formula", () => {
    expect(tied("c_0 + c_{2}")).toEqual(["fig-a/points.0", "fig-a/points.2"]);
    expect(tied("c_i, c_n, c_{n-1}, c_{i+1}")).toEqual(
      ["*", "n", "n-1", "*"].map((index) => `fig-a/points.${index}`),
    );
    // KaTeX sets what is below first.
    expect(tied("\\frac{c_1}{t^2}")).toEqual(["fig-a/t", "fig-a/points.1"]);
    expect(tied("B_2^3(t) + B_i^n(t)")).toEqual(["fig-a/weights.2", "fig-a/t", "fig-a/weights.*", "fig-a/t"]);
    expect(tied("p(t)")).toEqual(["fig-a/p", "fig-a/t"]);
    expect(tied("b_1^2, b_0^r", LEVELS)).toEqual(["fig-b/b.2.1", "fig-b/b.*.0"]);
  });

  test("leaves other symbols alone", () => {
    // Of another degree, derived, decorated, words, the room between rows.
    for (const tex of ["B_i^{n-1}", "c_i^{*}", "\\tilde c_1", "\\text{t}", "\\mathrm{t}", "x \\\\[3pt] y"])
      expect(tied(tex)).toEqual([]);
    expect(tied("p'(t)")).toEqual(["fig-a/t"]);
  });

  test("does not tie what no picture shows", () => {
    expect(tied("n")).toEqual([]);
    expect(tied("c_9")).toEqual([]);
    // Weights are computed there, but not drawn; another figure draws them.
    expect(tied("B_i^n + c_0", LEVELS)).toEqual(["fig-y/weights.*", "fig-b/points.0"]);
  });

  test("tells the meaning in any case, and stands in the page as a list", () => {
    const markup = html(`${CURVE}\n$n + c_9$\n\n${SYMBOLS}${SHOWN}`);
    expect(markup).toMatch(/data-symbol="6".*data-symbol="1"/s);
    expect(markup).toMatch(/<div id="symbol-6"><dt>.*<\/dt><dd>degree<\/dd>/s);
  });

  test("keeps indices below and above readable for KaTeX", () => {
    expect(html(`${CURVE}\n$x^n_t$\n\n${SYMBOLS}${SHOWN}`)).toContain('data-symbol="6"');
  });
});

describe("live numbers", () => {
  test("stand with their first value in room for the longest, in the language of the page", () => {
    const markup = (lang: Lang) => html(`${CURVE}\n$\\live{weights.1}{0.000}$`, lang);
    expect(markup("de")).toContain(
      '<span class="live mord" data-live="fig-a/weights.1" data-digits="3" data-room="5" style="--room:2.28em">0,432</span>',
    );
    expect(markup("en")).toMatch(/data-digits="3" data-room="5" style="--room:2.28em">0.432</);
    expect(markup("en")).toContain('<mn data-live="fig-a/weights.1" data-digits="3">0.432</mn>');
    expect(eyes(markup("de"))).toContain("0,432");
  });

  test("may be points, negative, and stand under braces and in matrices", () => {
    const markup = html(
      `${CURVE}\n$\\underbrace{t}_{\\live{t}{-0.0}} \\begin{pmatrix} \\live{p}{0.00} & \\live{points.1.0}{0.0} \\end{pmatrix}$`,
    );
    expect(markup.match(/class="live/g)).toHaveLength(3);
    expect(markup).toContain('class="live point');
    expect(markup).toMatch(/>\(1\.62, 1\.79\)</);
    expect(markup).not.toContain("@");
  });
});

describe("the list of symbols after a displayed formula", () => {
  const list = (tex: string) => {
    const markup = html(`${CURVE}\n$$\n${tex}\n$$\n\n${SYMBOLS}${SHOWN}`);
    const json = /data-symbols="([^"]*)"/.exec(markup)?.[1];
    return json === undefined ? null : JSON.parse(json.replaceAll("&quot;", '"'));
  };
  test("names each symbol once, as it is spoken, with its tie and entry", () => {
    expect(list("p(t) = c_0 + c_0")).toEqual([
      ["p(t)", "fig-a/p", 4],
      ["t", "fig-a/t", 5],
      ["c 0", "fig-a/points.0", 1],
    ]);
  });
  test("knows what a mere number is the number of", () => {
    expect(list("\\tie{points.1}{\\live{points.1}{0.0}}")).toEqual([
      ["c 1", "fig-a/points.1", 1, "fig-a/points.1"],
    ]);
  });
  test("is missing where there are none", () => {
    expect(list("x")).toBeNull();
  });
});

describe("identities", () => {
  const block = (tex: string) => `::: identity sum {#eq-a}\n$$\n${tex}\n$$\n:::\n`;
  test("carry their id and count", () => {
    const { lesson, problems } = compile(
      `${block("a + b\n = b \\, + a")}\n::: notation\n$$\nx\n$$\n:::\n\n$$\ny\n$$\n`,
    );
    expect(problems).toEqual([]);
    expect(lesson.body).toContain('id="eq-a"');
    expect(lesson.formulas.map(({ check, notation }) => [check, notation])).toEqual([
      ["sum", false],
      [null, true],
      [null, false],
    ]);
  });
  test("may hold ties and live numbers, and stay the same formula", () => {
    const tied = `${CURVE}\n${block("\\underbrace{\\tie{t}{a}}_{\\live{t}{0.0}} + b = b + a")}`;
    expect(compile(tied).problems).toEqual([]);
  });
  const BROKEN: readonly (readonly [string, string, RegExp])[] = [
    ["another formula", block("a + b = b - a"), /not the formula of the check "sum"/],
    ["unknown check", "::: identity summ\n$$\na\n$$\n:::", /no check "summ"/],
    ["two formulas", "::: identity sum\n$$\na+b=b+a\n$$\n$$\nc\n$$\n:::", /something else than one formula/],
    ["text", "::: notation\ntext\n:::", /something else than one formula/],
    ["attribute", "::: notation {fig=a}\n$$\nx\n$$\n:::", /has no "fig"/],
  ];
  test.each(BROKEN)("%s stops the build", (_, text, message) => {
    expect(compile(text).problems.map((one) => one.message)).toEqual([expect.stringMatching(message)]);
  });
});

describe("predictions", () => {
  const ANSWER = "\n::: answer\nBecause.\n:::\n";
  const CHOICE = `::: predict {#q figure=fig-a reveal="t=0.5"}\nWhere?\n\n- [ ] here $c_1$\n- [x] there\n${ANSWER}:::\n\n${CURVE}`;
  test("of a choice have options, the right one, the answer, figure and state", () => {
    const markup = html(CHOICE);
    expect(markup).toMatch(/data-kind="choice" data-figure="fig-a" data-reveal="t=0.5"/);
    expect(markup.match(/type="radio"/g)).toHaveLength(2);
    expect(markup).toMatch(/option wrong.*here.*option right.*there/s);
    expect(markup).not.toContain("[x]");
    expect(markup).toMatch(/<details class="answer">.*Because/s);
  });
  test("of a number and of a place say how near is right, and the figure gets the reader's mark", () => {
    const number = `::: predict {#q number=0.6 within=0.1}\nHow far?\n${ANSWER}:::\n`;
    expect(html(number)).toMatch(/data-kind="number" data-value="0.6" data-within="0.1"/);
    const place = `::: predict {#q figure=fig-a place=p within=0.2 at="plane 1,2" reveal="state=half"}\nWhere?\n${ANSWER}:::\n\n${CURVE}`;
    const markup = html(place);
    expect(markup).toMatch(/data-place="p" data-within="0.2"/);
    expect(markup).toContain('data-reveal="t=0.5"');
    expect(markup).toContain('data-guess="plane 1,2"');
  });
  const BROKEN: readonly (readonly [string, string, RegExp])[] = [
    ["no id", CHOICE.replace("#q ", ""), /has no id/],
    ["no answer", CHOICE.replace(ANSWER, ""), /has no answer/],
    ["nothing right", CHOICE.replace("[x]", "[ ]"), /one of them right/],
    ["misspelt attribute", CHOICE.replace("reveal", "reveel"), /no "reveel"/],
    ["unknown figure", CHOICE.replace("figure=fig-a", "figure=fig-x"), /no figure "fig-x"/],
    ["state unreadable", CHOICE.replace("t=0.5", "t=5"), /t=5 cannot be read/],
    ["no tolerance", `::: predict {#q number=1}\nx\n${ANSWER}:::`, /how near/],
    ["no number", `::: predict {#q number=a within=1}\nx\n${ANSWER}:::`, /no number/],
    [
      "place without figure",
      `::: predict {#q place=p within=1 at="plane 0,0"}\nx\n${ANSWER}:::`,
      /which figure/,
    ],
    [
      "place that is none",
      `${CURVE}\n::: predict {#q figure=fig-a place=t within=1 at="plane 0,0"}\nx\n${ANSWER}:::`,
      /"t" is no point/,
    ],
    [
      "mark without place",
      `${CURVE}\n::: predict {#q figure=fig-a place=p within=1}\nx\n${ANSWER}:::`,
      /where does the reader's mark begin/,
    ],
  ];
  test.each(BROKEN)("%s stops the build", (_, text, message) => {
    expect(compile(text).problems.map((one) => one.message)).toEqual([expect.stringMatching(message)]);
  });
});

test("a net’s symbols have two indices, its points one", () => {
  const patch = "::: demo bezier-patch {#fig-n normal=1}\nN.\n:::\n";
  const list = "::: symbols\n- $c_{ij}$ `points.i.j`: point\n:::\n";
  const markup = html(`${patch}\n$c_{12} + c_{ij} + c_{i+1,j} + c_{00} + \\tie{normal}{n}$\n\n${list}`);
  const names = ["points.6", "points.*", "points.*", "points.0", "normal"].map((name) => `fig-n/${name}`);
  expect(ties(markup).slice(0, 5)).toEqual(names);
});
