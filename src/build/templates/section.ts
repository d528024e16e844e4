import type { Html, SectionData } from "./types.ts";

/** From this many formulas on it pays not to lay a section out before it comes near. */
const MANY_FORMULAS = 10;

/**
 * A section of the lesson. Its guessed height keeps the scroll bar honest while it is not laid out yet; the
 * browser replaces the guess by the true height as soon as it has seen the section.
 */
export function section(data: SectionData): Html {
  if (data.formulas < MANY_FORMULAS) return `<section>\n${data.html}\n</section>`;
  const wide = 90 + (data.characters / 62) * 31 + data.figures * 640 + data.formulas * 9;
  const narrow = 90 + (data.characters / 36) * 29 + data.figures * 560 + data.formulas * 12;
  const style = `--about-wide:${Math.round(wide)}px;--about-narrow:${Math.round(narrow)}px`;
  return `<section class="long" style="${style}">\n${data.html}\n</section>`;
}
