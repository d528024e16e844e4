import { escapeHtml } from "../templates/html.ts";
import type { Page } from "./page.ts";

/** The list of pages for search engines. */
export function sitemap(pages: readonly Page[], siteUrl: string): string {
  const entries = pages
    .filter((page) => !page.noindex)
    .map((page) => `<url><loc>${escapeHtml(siteUrl + page.path)}</loc></url>`);
  return `<?xml version="1.0" encoding="UTF-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n${entries.join("\n")}\n</urlset>\n`;
}
