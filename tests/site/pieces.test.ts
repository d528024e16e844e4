import { describe, expect, test } from "vitest";
import { block } from "../../src/build/templates/block.ts";
import { figure } from "../../src/build/templates/figure.ts";
import { lessonPage } from "../../src/build/templates/lesson-page.ts";
import { predict } from "../../src/build/templates/predict.ts";
import { section } from "../../src/build/templates/section.ts";
import { stateLink } from "../../src/build/templates/state-link.ts";
import {
  BLOCK_KINDS,
  type FigureData,
  type Guess,
  type LessonPage,
} from "../../src/build/templates/types.ts";
import { LANGS } from "../../src/words/words.ts";

const data: FigureData = {
  id: "fig",
  demo: "bezier-curve",
  lang: "de",
  attributes: { points: "0,0;1,2", t: "0.5" },
  box: { wide: 0.5, narrow: 0.8, belowWide: 92, belowNarrow: 140 },
  svg: "<svg></svg>",
  caption: "<p>Ziehen Sie.</p>",
  printCaption: "",
};

describe("a figure", () => {
  test("is the markup of the contract", () => {
    expect(figure(data).replace(/\n/g, "")).toBe(
      '<figure id="fig" class="figure">' +
        '<curve-demo demo="bezier-curve" points="0,0;1,2" t="0.5" style="--wide:0.5;--narrow:0.8;--below-wide:92px;--below-narrow:140px"><svg></svg></curve-demo>' +
        "<figcaption><p>Ziehen Sie.</p></figcaption></figure>",
    );
  });

  test("has another caption on paper only where one is given", () => {
    expect(figure(data)).not.toContain("on-paper");
    const both = figure({ ...data, printCaption: "<p>Bei t = 0,5.</p>" });
    expect(both).toContain('<div class="on-screen"><p>Ziehen Sie.</p></div><div class="on-paper"><p>Bei t');
  });

  test("without a caption has no empty one", () => {
    expect(figure({ ...data, caption: "" })).not.toContain("figcaption");
  });
});

test("a state link is an ordinary link, whatever its query holds", () => {
  expect(stateLink({ lang: "de", figure: "fig", query: 'a="1"&b=2', html: "<b>x</b>" })).toBe(
    '<a class="state-link" href="#fig?a=&quot;1&quot;&amp;b=2"><b>x</b><span class="unseen"> (in der Figur)</span></a>',
  );
});

test("only a section with many formulas is laid out late, and then says about how high it is", () => {
  const few = section({ html: "x", formulas: 3, figures: 1, characters: 900 });
  const many = section({ html: "x", formulas: 60, figures: 1, characters: 900 });
  expect(few).not.toContain("style");
  expect(many).toMatch(/class="long" style="--about-wide:\d+px;--about-narrow:\d+px"/);
});

test("each kind of block has a name in each language", () => {
  for (const lang of LANGS) {
    const names = BLOCK_KINDS.map((kind) => {
      const html = block({ lang, kind, title: "", id: null, html: "<p>x</p>" });
      return /<strong>(.+?)<\/strong>/.exec(html)![1];
    });
    expect(new Set(names).size).toBe(BLOCK_KINDS.length);
  }
});

describe("a prediction", () => {
  const html = predict({
    lang: "de",
    id: "p1",
    question: "<p>Wo?</p>",
    guess: {
      kind: "choice",
      options: [
        { html: "hier", right: false },
        { html: "dort", right: true },
      ],
    },
    figure: { id: "fig", query: "t=0.5" },
    answer: "<p>Dort.</p>",
  });

  test("needs no script: options of one group, the answer behind a disclosure", () => {
    expect(html.match(/<input type="radio" name="p1"/g)).toHaveLength(2);
    expect(html).toContain("<details");
    expect(html.indexOf("Dort.")).toBeGreaterThan(html.indexOf("<details"));
  });

  test("says which option is right in words, not only by its looks", () => {
    expect(html).toMatch(/option wrong.*hier.*trifft nicht zu/);
    expect(html).toMatch(/option right.*dort.*richtig/);
  });

  test("names the figure that answers, and the state in which it does", () => {
    expect(html).toContain('data-figure="fig" data-reveal="t=0.5"');
  });

  test("of a number or a place asks for it in words", () => {
    const ask = (guess: Guess) =>
      predict({ lang: "en", id: "p", question: "", guess, figure: null, answer: "" });
    expect(ask({ kind: "number", value: 0.5, within: 0.1 })).toMatch(/Your number <input type="text"/);
    expect(ask({ kind: "place", name: "p", within: 0.1 })).toContain("arrow keys");
  });
});

describe("a lesson", () => {
  const lesson: LessonPage = {
    lang: "en",
    id: "bezier",
    number: 7,
    minutes: 40,
    title: "Bézier & co",
    lead: "Four points.",
    goals: ["draw $p$"],
    prerequisites: [{ href: "en/parameter/", title: "The parameter" }],
    addition: false,
    body: "<section>body</section>",
    root: "../../",
    previous: null,
    next: { href: "en/hermite/", title: "Hermite" },
  };

  test("has one h1, its number and time, goals and prerequisites", () => {
    const html = lessonPage(lesson);
    expect(html.match(/<h1>/g)).toHaveLength(1);
    expect(html).toContain("<h1>Bézier &amp; co</h1>");
    expect(html).toContain("Lesson 7 · about 40 minutes");
    expect(html).toContain('<a href="../../en/parameter/">The parameter</a>');
  });

  test("leads to its neighbours, those that exist", () => {
    const html = lessonPage(lesson);
    expect(html).toContain('rel="next" href="../../en/hermite/"');
    expect(html).not.toContain('rel="prev"');
    expect(lessonPage({ ...lesson, next: null })).not.toContain("<nav");
  });
});
