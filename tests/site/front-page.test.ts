import { describe, expect, test } from "vitest";
import { frontPage } from "../../src/build/templates/front-page.ts";
import { FRONT_WORDS } from "../../src/build/templates/front-words.ts";
import type { FrontPage, MapLesson } from "../../src/build/templates/types.ts";
import { LANGS } from "../../src/words/words.ts";

const lesson = (id: string, number: number, prerequisites: readonly string[] = []): MapLesson => ({
  id,
  number,
  href: `de/${id}/`,
  title: id.toUpperCase(),
  lead: "Worum es geht.",
  minutes: 30,
  prerequisites,
  addition: false,
});

const page = (...lessons: readonly MapLesson[]): FrontPage => ({
  lang: "de",
  root: "../",
  hero: {
    id: "hero",
    demo: "de-casteljau",
    lang: "de",
    attributes: {},
    box: { wide: 0.5, narrow: 0.7, belowWide: 52, belowNarrow: 100 },
    svg: "<svg></svg>",
    caption: "",
    printCaption: "",
  },
  heroLesson: null,
  parts: [{ title: "Teil", lessons }],
});

const rows = (html: string) => [...html.matchAll(/<li id="map-(.+?)">(.*?)<\/li>/gs)];

describe("the course map", () => {
  test("draws an arc back to each lesson that one builds on, over so many rows", () => {
    const html = frontPage(page(lesson("a", 1), lesson("b", 2, ["a"]), lesson("c", 3, ["a", "b"])));
    const arcs = rows(html).map(([, , row]) => [...row!.matchAll(/--rows:(\d+)/g)].map(([, k]) => Number(k)));
    expect(arcs).toEqual([[], [1], [2, 1]]);
    expect(html).toContain("Baut auf: A, B");
  });

  test("passes over lessons that do not exist yet, and never points forward", () => {
    const html = frontPage(page(lesson("a", 1, ["b", "missing"]), lesson("b", 2)));
    expect(html).not.toContain("--rows");
    expect(html).not.toContain("Baut auf");
  });

  test("stands for one lesson as well as for none", () => {
    expect(rows(frontPage(page(lesson("bezier", 7))))).toHaveLength(1);
    const none = frontPage({ ...page(), parts: [] });
    expect(rows(none)).toHaveLength(0);
    expect(none).not.toContain('class="begin"');
  });
});

describe("the uses of curves", () => {
  test("link to their lesson once it exists", () => {
    const html = frontPage(page(lesson("bezier", 7)));
    expect(html.match(/class="more"/g)).toHaveLength(1);
    expect(html).toContain('Mehr dazu: <a href="../de/bezier/">BEZIER</a>');
  });

  test("are the same in both languages, each with a picture of its own", () => {
    const [de, en] = LANGS.map((lang) =>
      FRONT_WORDS[lang].uses.map(({ picture, lesson }) => [picture, lesson]),
    );
    expect(de).toEqual(en);
    expect(new Set(de!.map(([picture]) => picture)).size).toBe(de!.length);
  });
});

test("nothing on the pages shouts", () => {
  for (const lang of LANGS) expect(frontPage({ ...page(), lang })).not.toContain("!");
});
