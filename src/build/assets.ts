/** Style sheets and scripts of a kind of page, as paths below the site's root. */
export interface PageAssets {
  readonly styles: readonly string[];
  readonly scripts: readonly string[];
  /** Fonts of the first lines, asked for at once: text fonts that come late are not shown at all. */
  readonly fonts: readonly string[];
}

/** What the bundler made, or the dev server serves, for each kind of page. */
export interface Assets {
  readonly page: PageAssets;
  readonly embed: PageAssets;
}

/** The entries in `src/site/entries/`; `embed-js` becomes `embed.js` for foreign pages. */
export const ENTRIES = {
  page: "src/site/entries/page.ts",
  embed: "src/site/entries/embed.ts",
  "embed-js": "src/site/entries/embed-js.ts",
} as const;
