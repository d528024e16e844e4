import { attributes, escapeHtml, lines } from "./html.ts";
import type { Chrome, Html, NavLesson, NavPart, ShellPage } from "./types.ts";
import { WORDS } from "./words.ts";

/**
 * The course as a list of parts and lessons, with the sections of the current one. A popover: on narrow
 * screens the browser itself opens and closes it, without a script; wide screens show it in place.
 */
export function courseNav({ lang, root }: ShellPage, { parts, links }: Chrome): Html {
  const words = WORDS[lang];
  return lines(
    `<nav${attributes({ id: "contents", class: "contents", popover: true, "aria-label": words.mainNavigation })}>`,
    ...parts.map((part, i) => navPart(part, `part-${i + 1}`, root)),
    links.length > 0 &&
      `<ul class="contents-links">${links.map(({ href, title }) => `<li><a${attributes({ href: root + href })}>${escapeHtml(title)}</a></li>`).join("")}</ul>`,
    `<button class="contents-close" type="button" popovertarget="contents" popovertargetaction="hide">${words.closeContents}</button>`,
    "</nav>",
  );
}

function navPart({ title, lessons }: NavPart, id: string, root: string): Html {
  return lines(
    `<p class="part" id="${id}">${escapeHtml(title)}</p>`,
    `<ul aria-labelledby="${id}">`,
    ...lessons.map((lesson) => navLesson(lesson, root)),
    "</ul>",
  );
}

function navLesson(lesson: NavLesson, root: string): Html {
  const link = attributes({ href: root + lesson.href, "aria-current": lesson.current ? "page" : null });
  const sections = lesson.sections.map(
    ({ id, title }) => `<li><a${attributes({ href: `#${id}` })}>${title}</a></li>`,
  );
  return lines(
    `<li><a${link}>${escapeHtml(lesson.title)}</a>`,
    sections.length > 0 && `<ul class="sections">\n${sections.join("\n")}\n</ul>`,
    "</li>",
  );
}
