import { FRONT_WORDS } from "./front-words.ts";
import { attributes, escapeHtml, lines } from "./html.ts";
import type { FrontPage, Html, MapLesson } from "./types.ts";

/**
 * The lessons in order, with an arc from each back to those it builds on. All rows are equally high, so
 * that an arc over k rows is k rows high: it needs no script and fits any number of lessons.
 */
export function courseMap({ lang, root, parts }: FrontPage): Html {
  const all = parts.flatMap((part) => part.lessons);
  return lines(
    '<div class="map">',
    ...parts.map((part) =>
      lines(
        '<div class="map-part">',
        `<h3>${escapeHtml(part.title)}</h3>`,
        "<ol>",
        ...part.lessons.map((lesson) => row(lesson, all, lang, root)),
        "</ol>",
        "</div>",
      ),
    ),
    "</div>",
  );
}

function row(lesson: MapLesson, all: readonly MapLesson[], lang: FrontPage["lang"], root: string): Html {
  const words = FRONT_WORDS[lang];
  const place = all.indexOf(lesson);
  const before = all.filter(({ id }, i) => i < place && lesson.prerequisites.includes(id));
  const notes = [words.minutes(lesson.minutes), ...(lesson.addition ? [words.addition] : [])].join(" · ");
  return lines(
    `<li${attributes({ id: `map-${lesson.id}` })}>`,
    ...before.map((one) => arc(place - all.indexOf(one), all.length - 1)),
    `<a${attributes({ href: root + lesson.href })}><span class="number">${lesson.number}</span><span class="map-title">${escapeHtml(lesson.title)}</span></a>`,
    `<p class="map-lead">${lesson.lead}</p>`,
    `<p class="map-notes">${notes}${before.length > 0 ? `<span class="map-before"> · ${words.buildsOn} ${before.map(({ title }) => escapeHtml(title)).join(", ")}</span>` : ""}</p>`,
    "</li>",
  );
}

/** An arc over so many rows: the farther, the wider; the longest one fills the space beside the list. */
function arc(rows: number, most: number): Html {
  const left = Math.round(100 - 130 * Math.sqrt(rows / most));
  const style = `--rows:${rows}`;
  return `<svg${attributes({ class: "arc", viewBox: "0 0 100 100", preserveAspectRatio: "none", "aria-hidden": "true", style })}><path d="M100 0C${left} 0 ${left} 100 100 100" vector-effect="non-scaling-stroke"/></svg>`;
}
