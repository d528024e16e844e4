import type { Lang } from "../../words/words.ts";
import { contentSecurityPolicy } from "../csp.ts";
import { BOOT } from "../templates/boot.ts";
import { shell } from "../templates/shell.ts";
import type { Chrome, NavPart, ShellPage } from "../templates/types.ts";
import { lessonsOf } from "./lessons-of.ts";
import { otherLang, type Page, type PageContext, type PageOptions, rootOf } from "./page.ts";

/** The whole document of a page. */
export function renderPage(page: Page, context: PageContext, options: PageOptions): string {
  const root = rootOf(page.path);
  return shell({
    lang: page.lang,
    title: page.title,
    description: page.description,
    root,
    ...options.assets[page.assets],
    bootScript: BOOT,
    csp: options.policy ? contentSecurityPolicy({ scripts: [BOOT] }) : null,
    chrome: page.chrome && chromeOf(page, context),
    body: page.body(root),
    bodyClass: page.bodyClass,
    ...(page.noindex ? { noindex: true } : {}),
    ...absoluteAddresses(page, options.siteUrl),
  });
}

function chromeOf(page: Page, context: PageContext): Chrome {
  return {
    parts: navParts(page, context),
    links: [],
    alternate: page.alternate ?? `${otherLang(page.lang)}/`,
  };
}

function navParts(page: Page, { course, parts }: PageContext): NavPart[] {
  const current = page.chrome?.lesson ?? null;
  return parts
    .map((part) => ({
      title: part.title[page.lang],
      lessons: lessonsOf(part, course, page.lang).map(({ id, front, headings }) => ({
        id,
        href: `${page.lang}/${id}/`,
        title: front.short,
        current: id === current?.id,
        sections:
          id === current?.id
            ? headings.filter(({ level }) => level === 2).map(({ id, html }) => ({ id, title: html }))
            : [],
      })),
    }))
    .filter(({ lessons }) => lessons.length > 0);
}

/** Only a site that knows its address can name it. */
function absoluteAddresses(
  page: Page,
  siteUrl: string | null,
): Pick<ShellPage, "canonical" | "alternates"> | null {
  if (siteUrl === null || page.noindex) return null;
  const canonical = siteUrl + page.path;
  if (page.alternate === null) return { canonical };
  const address = (lang: Lang) => siteUrl + (lang === page.lang ? page.path : page.alternate);
  return {
    canonical,
    alternates: [
      { lang: "de", href: address("de") },
      { lang: "en", href: address("en") },
      { lang: "x-default", href: address("de") },
    ],
  };
}
