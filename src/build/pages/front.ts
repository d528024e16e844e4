import { changed, initialState } from "../../demo/state.ts";
import type { Lang } from "../../words/words.ts";
import { readState } from "../markdown/read-state.ts";
import { frontPage } from "../templates/front-page.ts";
import { SITE_NAME } from "../templates/words.ts";
import { DESCRIPTION } from "./descriptions.ts";
import { linkTo } from "./lesson.ts";
import { lessonsOf, numberOf } from "./lessons-of.ts";
import { otherLang, type Page, type PageContext } from "./page.ts";

/** The front page: a live figure and the course map. */
export function front(lang: Lang, { course, parts, demos, still, hero }: PageContext): Page {
  const demo = demos.get(hero.demo);
  if (!demo) throw new RangeError(`lessons/toc.ts: hero: unknown demo "${hero.demo}"`);
  const { patch, problems } = readState(demo, hero.query);
  if (problems[0])
    throw new RangeError(`lessons/toc.ts: hero: ${problems[0].message}; ${problems[0].remedy}`);
  const lesson = course.lessons.find((one) => one.id === hero.lesson && one.lang === lang);
  return {
    path: `${lang}/`,
    lang,
    title: SITE_NAME,
    description: DESCRIPTION[lang],
    bodyClass: "front-page",
    assets: "page",
    alternate: `${otherLang(lang)}/`,
    chrome: { lesson: null },
    sources: [],
    body: (root) =>
      frontPage({
        lang,
        root,
        hero: {
          id: "hero",
          demo: demo.id,
          lang,
          attributes: Object.fromEntries(new URLSearchParams(hero.query)),
          ...still(demo, changed(demo, initialState(demo), patch), lang),
          caption: "",
          printCaption: "",
        },
        heroLesson: lesson ? linkTo(lesson) : null,
        parts: parts
          .map((part) => ({
            title: part.title[lang],
            lessons: lessonsOf(part, course, lang).map((one) => ({
              ...linkTo(one),
              id: one.id,
              number: numberOf(one.id, parts),
              lead: one.front.lead,
              minutes: one.front.minutes,
              prerequisites: one.front.prerequisites.map(({ value }) => value),
              addition: one.front.addition,
            })),
          }))
          .filter(({ lessons }) => lessons.length > 0),
      }),
  };
}
