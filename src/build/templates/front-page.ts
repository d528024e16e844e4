import { courseMap } from "./course-map.ts";
import { curveDemo } from "./figure.ts";
import { FRONT_WORDS, type Use } from "./front-words.ts";
import { attributes, escapeHtml, lines } from "./html.ts";
import { picture } from "./pictures/index.ts";
import type { FrontPage, Html, Link, MapLesson } from "./types.ts";

/** The front page: what the course is, a living figure, what such curves are for, the map of the course. */
export function frontPage(page: FrontPage): Html {
  const words = FRONT_WORDS[page.lang];
  const lessons = page.parts.flatMap((part) => part.lessons);
  return lines(
    '<div class="front">',
    hero(page, lessons[0]),
    '<section class="uses" aria-labelledby="uses">',
    `<h2 id="uses">${words.usesTitle}</h2>`,
    "<ul>",
    ...words.uses.map((one) => use(one, lessons, page)),
    "</ul>",
    "</section>",
    '<section class="plan" aria-labelledby="course">',
    `<h2 id="course">${words.mapTitle}</h2>`,
    lessons.length > 1 && `<p>${words.mapIntro}</p>`,
    courseMap(page),
    "</section>",
    '<section class="how" aria-labelledby="how">',
    `<h2 id="how">${words.howTitle}</h2>`,
    `<dl>${words.how.map(([name, text]) => `<div><dt>${name}</dt><dd>${text}</dd></div>`).join("")}</dl>`,
    "</section>",
    "</div>",
  );
}

function hero({ lang, root, hero, heroLesson }: FrontPage, first: MapLesson | undefined): Html {
  const words = FRONT_WORDS[lang];
  const begin = first && `<a${attributes({ class: "begin", href: root + first.href })}>${words.begin}</a>`;
  const more = heroLesson ? ` ${words.heroLesson(anchor(heroLesson, root))}` : "";
  return lines(
    '<header class="hero">',
    '<div class="hero-words">',
    `<h1>${words.title}</h1>`,
    `<p class="lead">${words.lead}</p>`,
    `<p class="hero-links">${begin ?? ""}<a href="#course">${words.map}</a></p>`,
    "</div>",
    `<figure${attributes({ id: hero.id, class: "figure" })}>`,
    curveDemo(hero),
    `<figcaption><p>${words.heroCaption}${more}</p></figcaption>`,
    "</figure>",
    "</header>",
  );
}

function use(
  { picture: name, lesson, title, text }: Use,
  lessons: readonly MapLesson[],
  page: FrontPage,
): Html {
  const target = lessons.find(({ id }) => id === lesson);
  const words = FRONT_WORDS[page.lang];
  return lines(
    `<li>${picture(name)}`,
    `<h3>${title}</h3>`,
    `<p>${text}</p>`,
    target !== undefined && `<p class="more">${words.moreIn} ${anchor(target, page.root)}</p>`,
    "</li>",
  );
}

function anchor({ href, title }: Link, root: string): Html {
  return `<a${attributes({ href: root + href })}>${escapeHtml(title)}</a>`;
}
