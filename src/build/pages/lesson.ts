import type { Lang } from "../../words/words.ts";
import type { Lesson } from "../compile-lesson.ts";
import { lessonPage } from "../templates/lesson-page.ts";
import type { Link } from "../templates/types.ts";
import { numberOf } from "./lessons-of.ts";
import { otherLang, type Page, type PageContext } from "./page.ts";

/** A lesson in one language. */
export function lessonBody(id: string, lang: Lang, { course, parts }: PageContext): Page {
  const all = course.lessons.filter((lesson) => lesson.lang === lang);
  const place = all.findIndex((lesson) => lesson.id === id);
  const lesson = all[place]!;
  const { front } = lesson;
  const prerequisites = front.prerequisites.flatMap(({ value }) => all.filter((one) => one.id === value));
  return {
    path: `${lang}/${id}/`,
    lang,
    title: front.title,
    description: front.description,
    bodyClass: "lesson-page",
    assets: "page",
    alternate: `${otherLang(lang)}/${id}/`,
    chrome: { lesson },
    sources: [`lessons/${id}/de.md`, `lessons/${id}/en.md`],
    body: (root) =>
      lessonPage({
        lang,
        id,
        number: numberOf(id, parts),
        minutes: front.minutes,
        title: front.title,
        lead: front.lead,
        goals: front.goals,
        prerequisites: prerequisites.map(linkTo),
        addition: front.addition,
        body: lesson.body,
        root,
        previous: place > 0 ? linkTo(all[place - 1]!) : null,
        next: place + 1 < all.length ? linkTo(all[place + 1]!) : null,
      }),
  };
}

export function linkTo({ id, lang, front }: Lesson): Link {
  return { href: `${lang}/${id}/`, title: front.title };
}
