import { attributes, escapeHtml, lines } from "./html.ts";
import { CONTENTS_ICON, THEME_ICONS } from "./icons.ts";
import { logo } from "./logo.ts";
import { courseNav } from "./nav.ts";
import type { Chrome, Html, ShellPage } from "./types.ts";
import { SITE_NAME, WORDS } from "./words.ts";

/** Header, course navigation, main part and footer of a site page. */
export function chrome(page: ShellPage, around: Chrome): Html {
  return lines(
    `<a class="skip" href="#main">${WORDS[page.lang].skip}</a>`,
    header(page, around),
    '<div class="page">',
    courseNav(page, around),
    '<main id="main" tabindex="-1">',
    page.body,
    "</main>",
    "</div>",
    footer(page),
  );
}

function header({ lang, root }: ShellPage, around: Chrome): Html {
  const words = WORDS[lang];
  const links = [{ href: `${lang}/`, title: words.course }, ...around.links].map(
    ({ href, title }) => `<a${attributes({ href: root + href })}>${escapeHtml(title)}</a>`,
  );
  return lines(
    '<header class="top">',
    `<a${attributes({ class: "home", href: `${root}${lang}/`, "aria-label": words.home })}>${logo()}<span class="wordmark">${SITE_NAME}</span></a>`,
    around.links.length > 0 && `<div class="top-links">${links.join("")}</div>`,
    '<div class="top-tools">',
    language(lang === "de" ? "en" : "de", root + around.alternate, words),
    themeSwitch(words),
    `<button class="tool contents-button" type="button" popovertarget="contents" aria-label="${words.contents}">${CONTENTS_ICON}<span>${words.contents}</span></button>`,
    "</div>",
    "</header>",
  );
}

type Words = (typeof WORDS)["de"];

function language(other: string, href: string, words: Words): Html {
  const link = attributes({
    class: "tool language",
    href,
    lang: other,
    hreflang: other,
    "data-language": other,
  });
  return `<a${link}><span class="long">${words.otherLanguage}</span><abbr class="short" title="${words.otherLanguage}">${words.otherLanguageShort}</abbr></a>`;
}

/** The names of the three settings travel with the button, so that the script knows no language. */
function themeSwitch(words: Words): Html {
  const names = {
    class: "tool theme-switch",
    type: "button",
    "aria-label": words.themeAuto,
    title: words.themeAuto,
    "data-auto": words.themeAuto,
    "data-light": words.themeLight,
    "data-dark": words.themeDark,
  };
  return `<button${attributes(names)}>${THEME_ICONS}</button>`;
}

function footer({ lang }: ShellPage): Html {
  const words = WORDS[lang];
  const licence = `https://creativecommons.org/licenses/by/4.0/deed.${lang}`;
  return lines(
    '<footer class="foot">',
    `<p>${words.footer}</p>`,
    `<p><a${attributes({ href: licence, rel: "license" })}>${words.textLicence}</a> · ${words.codeLicence}</p>`,
    "</footer>",
  );
}
