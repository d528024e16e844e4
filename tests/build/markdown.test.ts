import { describe, expect, test } from "vitest";
import { compile, FIGURE, html } from "./fixture.ts";

/** Markup without what is only heard, and without KaTeX's boxes. */
const plain = (markup: string) =>
  markup
    .replace(/<span class="katex-mathml">.*?<\/math><\/span>/gs, "")
    .replace(/<[^>]*>/g, "")
    .replace(/\s+/g, " ")
    .trim();

describe("formulas", () => {
  test("stand in the page twice: boxes for the eyes, MathML for the ears", () => {
    const markup = html("So $c_0$ ist.");
    expect(markup).toContain('<span class="katex-mathml"><math');
    expect(markup).toContain('class="katex-html" aria-hidden="true"');
  });

  test("displayed ones have a box that can scroll", () => {
    expect(html("$$\nx\n$$")).toMatch(/^<div class="formula"[^>]*><span class="katex-display">/);
  });

  test("numbers follow the language", () => {
    expect(plain(html("$\\num{-0.5}$", "de"))).toBe("−0,5");
    expect(plain(html("$\\num{-0.5}$", "en"))).toBe("−0.5");
  });

  test("a short one keeps the punctuation that touches it", () => {
    const glued = /<span class="glue">\(<span class="katex">.*<\/span>\),<\/span> und/;
    expect(html("bei ($t$), und")).toMatch(glued);
    expect(html("bei $t$ und")).not.toContain("glue");
    const long = html("bei $a + b + c + d + e + f + g + h + i$, und");
    expect(long).not.toContain("glue");
  });

  test("an escaped dollar is a dollar", () => {
    expect(html("5 \\$ und 6 \\$")).toBe("<p>5 $ und 6 $</p>\n");
  });
});

describe("figures", () => {
  test("hold the demo with its attributes and the still picture of the same state", () => {
    const markup = html("::: demo seesaw {#fig-a t=0.25 controls=compact}\nA *caption*.\n:::");
    expect(markup).toMatch(
      /^<figure id="fig-a"[^>]*>\n<curve-demo demo="seesaw" t="0.25" controls="compact"/,
    );
    expect(markup).toContain("'t':0.25");
    expect(markup).toContain("--wide:0.5;--narrow:0.7;--below-wide:52px;--below-narrow:100px");
    expect(markup).toMatch(/<figcaption>.*A <em>caption<\/em>/s);
  });

  test("a named state counts less than a parameter that is named", () => {
    expect(html("::: demo seesaw {#f state=up}\nC\n:::")).toContain("'t':1,");
    expect(html("::: demo seesaw {#f t=0.1 state=up}\nC\n:::")).toContain("'t':0.1,");
  });

  test("a caption for paper stands inside, with as many colons", () => {
    const markup = html("::: demo seesaw {#f}\nScreen.\n\n::: print\nPaper.\n:::\n:::\n\nAfter.");
    expect(markup).toMatch(/<figcaption>.*Screen.*Paper.*<\/figcaption>.*<p>After\.<\/p>/s);
    const text = compile("::: demo seesaw {#f}\nScreen.\n\n::: print\nPaper.\n:::\n:::").lesson.body;
    expect(text.match(/Paper/g)).toHaveLength(1);
  });

  test("quoted values may hold spaces, points need no quotes", () => {
    const { lesson, problems } = compile('::: demo seesaw {#f ends="0,0;1,0.5"}\nC\n:::');
    expect(problems).toEqual([]);
    expect(lesson.body).toContain("'ends':[[0,0],[1,0.5]]");
    expect(html("::: demo seesaw {#f ends=0,0;1,0.5}\nC\n:::")).toContain("'ends':[[0,0],[1,0.5]]");
  });
});

describe("links", () => {
  test("to a state are ordinary links to the figure", () => {
    const markup = html(`Siehe [[ganz *oben*]](demo:fig-a?t=1).\n\n${FIGURE}`);
    expect(markup).toContain(
      '<a class="state-link" href="#fig-a?t=1">ganz <em>oben</em><span class="unseen"> (in der Figur)</span></a>.',
    );
  });

  test("to a named state say what it is, so that the address can be read anywhere", () => {
    expect(html(`[[x]](demo:fig-a?state=up)\n\n${FIGURE}`)).toContain('href="#fig-a?t=1"');
  });

  test("write points as the pages' addresses do", () => {
    const markup = html(`[[x]](demo:fig-a?ends=0,0;1,0.5&t=0.5)\n\n${FIGURE}`);
    expect(markup).toContain('href="#fig-a?t=0.5&amp;ends=0,0;1,0.5"');
  });

  test("may hold a formula", () => {
    expect(html(`[[$t = 1$]](demo:fig-a?t=1)\n\n${FIGURE}`)).toMatch(
      /<a class="state-link"[^>]*><span class="katex">/,
    );
  });

  test("to other lessons are relative, and kept for the check", () => {
    const { lesson } = compile(
      "[a](lesson:hermite#end) [b](lesson:runge) [c](#x) [d](https://example.org/a?b#c)",
    );
    expect([...lesson.body.matchAll(/href="([^"]*)"/g)].map(([, href]) => href)).toEqual([
      "../hermite/#end",
      "../runge/",
      "#x",
      "https://example.org/a?b#c",
    ]);
    expect(lesson.links.map(({ lesson: id, anchor }) => [id, anchor])).toEqual([
      ["hermite", "end"],
      ["runge", null],
      [null, "x"],
    ]);
  });
});

describe("blocks", () => {
  test("have the words of the page's language, a title in markdown and an id", () => {
    const markup = html("::: theorem Die *Hülle* $H$ {#thm-hull}\nText.\n:::");
    expect(markup).toMatch(/<div id="thm-hull" class="block theorem">/);
    expect(markup).toMatch(/Satz.*Die <em>Hülle<\/em> <span class="katex">/s);
    expect(html("::: theorem\nText.\n:::", "en")).toContain("Theorem");
  });

  test("stand within each other, within lists, and show colons in code", () => {
    expect(html("::: note\n::: example\na\n:::\n:::\nb").replace(/\s+/g, "")).toMatch(
      /class="blocknote".*class="blockexample".*<p>a<\/p><\/div><\/div><p>b<\/p>$/,
    );
    expect(html("- one\n\n  ::: note\n  a\n  :::\n- two")).toMatch(/<li>.*block note.*<\/li>\n<li>/s);
    expect(html("::: note\n```\n:::\n```\n:::")).toMatch(/<code>:::\n<\/code>/);
  });

  test("show the very lines of a function", () => {
    expect(html("::: code src/math/a.ts half\n:::")).toContain("<code>return x / 2;</code>");
  });
});

test("a section reaches from its heading to the next of the same level", () => {
  const markup = html("Vor.\n\n## A {#a}\n\na\n\n### B {#b}\n\nb\n\n## C {#c}\n\nc").replace(/\s+/g, "");
  expect(markup).toBe(
    '<p>Vor.</p><section><h2id="a">A</h2><p>a</p><h3id="b">B</h3><p>b</p></section><section><h2id="c">C</h2><p>c</p></section>',
  );
});

test("headings are listed for the navigation, with their formulas", () => {
  const { lesson } = compile("## Grad $n$ {#degree}\n\n### Tiefer {#deeper}");
  expect(lesson.headings.map(({ id, level }) => [id, level])).toEqual([
    ["degree", 2],
    ["deeper", 3],
  ]);
  expect(lesson.headings[0]!.html).toMatch(/^Grad <span class="katex">/);
});

test("footnotes stand at the end of the lesson and lead back", () => {
  const markup = html("## A {#a}\n\nText[^1].\n\n[^1]: Die *Quelle*.", "en");
  expect(markup).toMatch(
    /<sup class="footnote-ref"><a id="footnote-ref-1" href="#footnote-1" aria-label="Footnote 1">1</,
  );
  expect(markup).toMatch(
    /<\/section>\n<section class="footnotes" aria-label="Footnotes">.*<em>Quelle<\/em>/s,
  );
  expect(markup).toContain('href="#footnote-ref-1" aria-label="Back to the text"');
});

test("foreign words name their language", () => {
  expect(html("Das *gather*{lang=en} ist")).toContain('<em lang="en">gather</em>');
});

test("markup of the author's is shown, never run", () => {
  expect(html("a \\<script> b")).toContain("&lt;script&gt;");
});

test("a lesson in one piece does not carry anything over to the next", () => {
  const first = html("a[^1]\n\n[^1]: b");
  expect(html("a[^1]\n\n[^1]: b")).toBe(first);
});
