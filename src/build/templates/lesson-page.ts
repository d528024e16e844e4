import { attributes, escapeHtml, lines } from "./html.ts";
import type { Html, LessonPage, Link } from "./types.ts";
import { WORDS } from "./words.ts";

/** The body of a lesson: what it is about, what it gives, the lesson itself, its neighbours. */
export function lessonPage(lesson: LessonPage): Html {
  const words = WORDS[lesson.lang];
  return lines(
    '<article class="lesson">',
    '<header class="lesson-head">',
    `<p class="kicker">${words.lesson(lesson.number, lesson.minutes)}</p>`,
    `<h1>${escapeHtml(lesson.title)}</h1>`,
    `<p class="lead">${lesson.lead}</p>`,
    lesson.addition && `<p class="beyond">${words.addition}</p>`,
    beforehand(lesson),
    "</header>",
    lesson.body,
    "</article>",
    neighbours(lesson),
  );
}

function beforehand({ lang, root, goals, prerequisites }: LessonPage): Html {
  const words = WORDS[lang];
  const links = prerequisites.map(
    ({ href, title }) => `<a${attributes({ href: root + href })}>${escapeHtml(title)}</a>`,
  );
  return lines(
    goals.length > 0 &&
      `<div class="goals"><p class="label">${words.goals}</p>\n<ul>\n${goals.map((goal) => `<li>${goal}</li>`).join("\n")}\n</ul></div>`,
    links.length > 0 &&
      `<p class="before"><span class="label">${words.prerequisites}</span> ${links.join(", ")}</p>`,
  );
}

function neighbours({ lang, root, previous, next }: LessonPage): Html {
  if (!previous && !next) return "";
  const words = WORDS[lang];
  return lines(
    `<nav${attributes({ class: "neighbours", "aria-label": words.neighbours })}>`,
    previous && neighbour(previous, root, "prev", words.previous),
    next && neighbour(next, root, "next", words.next),
    "</nav>",
  );
}

function neighbour({ href, title }: Link, root: string, rel: "prev" | "next", label: string): Html {
  return `<a${attributes({ class: rel, rel, href: root + href })}><span class="label">${label}</span><span class="title">${escapeHtml(title)}</span></a>`;
}
