/** The two languages of the course; German is the first, English an equal second. */
export const LANGS = ["de", "en"] as const;
export type Lang = (typeof LANGS)[number];

/** One text in both languages. A missing translation is a type error. */
export type Words = Readonly<Record<Lang, string>>;

/** Builds a text in both languages from one function, so that numbers can be formatted for each. */
export function inBoth(write: (lang: Lang) => string): Words {
  return { de: write("de"), en: write("en") };
}

/** The same text in both languages: symbols, names, numbers without a separator. */
export function same(text: string): Words {
  return { de: text, en: text };
}
