import { expect, test } from "@playwright/test";
import { parseSync } from "vite";
import { files, pages, readFile } from "./support/dist.ts";

/** Everything a document or style sheet points to, as it is written. */
function references(file: string): string[] {
  const text = readFile(file).replace(/<script>.*?<\/script>/gs, "");
  const found = file.endsWith(".css")
    ? text.matchAll(/url\(["']?([^"')]+)["']?\)/g)
    : text.matchAll(/\s(?:href|src)="([^"]*)"/g);
  return [...found].map(([, target]) => target!.replaceAll("&amp;", "&"));
}

const documents = files.filter((file) => /\.(html|css)$/.test(file));

test("every link, script, style sheet, font and anchor is there, by a relative address", () => {
  const wrong: string[] = [];
  let checked = 0;
  for (const file of documents) {
    for (const target of references(file)) {
      if (/^(https:|mailto:|data:)/.test(target)) continue;
      checked++;
      if (/^(\/|[a-z]+:)/.test(target)) wrong.push(`${file}: ${target} is not relative`);
      const url = new URL(target, `https://host/${file}`);
      const path = decodeURIComponent(url.pathname).slice(1);
      const place = path === "" || path.endsWith("/") ? `${path}index.html` : path;
      if (!files.includes(place)) wrong.push(`${file}: ${target} is not there`);
      const id = decodeURIComponent(url.hash.slice(1)).split("?")[0]!;
      if (id && files.includes(place) && !readFile(place).includes(` id="${id}"`)) {
        wrong.push(`${file}: ${target}: no such anchor`);
      }
    }
  }
  expect(checked).toBeGreaterThan(100);
  expect(wrong).toEqual([]);
});

test("scripts load each other by relative addresses, so that embed.js works from any page", () => {
  const scripts = files.filter((file) => file.endsWith(".js"));
  expect(scripts).toContain("embed.js");
  let checked = 0;
  for (const file of scripts) {
    const text = readFile(file);
    const { staticImports, dynamicImports } = parseSync(file, text).module;
    const fixed = staticImports.map((one) => one.moduleRequest.value);
    const lazy = dynamicImports.map(({ moduleRequest: { start, end } }) => text.slice(start + 1, end - 1));
    checked += fixed.length + lazy.length;
    expect(
      [...fixed, ...lazy].filter((path) => !path.startsWith("./") && !path.startsWith("../")),
      file,
    ).toEqual([]);
  }
  expect(checked).toBeGreaterThan(5);
});

test("every page says its language, its title, its description, its icon and its policy", () => {
  for (const page of pages) {
    const html = readFile(`${page}index.html`);
    expect(html, page).toMatch(/<html lang="(de|en)"/);
    expect(html, page).toMatch(/<title>[^<]+<\/title>/);
    expect(html, page).toMatch(/<meta name="description" content="[^"]{20,}"/);
    expect(html, page).toMatch(/<link rel="icon" href="(\.\.\/)*icon\.svg"/);
    expect(html, page).toContain('<meta http-equiv="Content-Security-Policy" content="default-src \'none\';');
    expect(html, page).not.toMatch(/<link[^>]*rel="stylesheet"[^>]*crossorigin/);
  }
});

test("nothing of this machine is in the build", () => {
  const here = process.cwd();
  for (const file of files.filter((one) => /\.(html|css|js|txt|xml|svg)$/.test(one))) {
    expect(readFile(file).includes(here), file).toBe(false);
  }
});

test("licences of all that is shipped are listed, and lie beside the fonts", () => {
  const text = readFile("licences.txt");
  for (const name of [
    "katex",
    "lil-gui",
    "@fontsource-variable/source-serif-4",
    "@fontsource-variable/source-sans-3",
  ]) {
    expect(text).toContain(`\n${name}\n`);
  }
  expect(readFile("assets/licence-source-serif-4.txt")).toContain("SIL OPEN FONT LICENSE");
});

test("without SITE_URL no absolute address of the site is written", () => {
  expect(process.env.SITE_URL ?? "").toBe("");
  expect(files).not.toContain("sitemap.xml");
  for (const page of pages) expect(readFile(`${page}index.html`)).not.toMatch(/rel="(canonical|alternate)"/);
});
