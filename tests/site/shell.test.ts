import { describe, expect, test } from "vitest";
import { shell } from "../../src/build/templates/shell.ts";
import type { ShellPage } from "../../src/build/templates/types.ts";

const page: ShellPage = {
  lang: "de",
  title: "Kurven & Flächen",
  description: 'Sagt „<b>“ und "so"',
  root: "../../",
  styles: ["assets/fonts.css", "assets/page.css"],
  fonts: ["assets/text.woff2"],
  scripts: ["assets/page.js"],
  bootScript: "boot()",
  csp: "default-src 'none'",
  chrome: null,
  body: "<main>{{lang}} $& $1</main>",
  bodyClass: "lesson-page",
};

const chrome: ShellPage["chrome"] = {
  alternate: "en/bezier/",
  links: [{ href: "de/demos/", title: "Figuren" }],
  parts: [
    {
      title: "Teil <1>",
      lessons: [
        { id: "runge", href: "de/runge/", title: "Runge", current: false, sections: [] },
        {
          id: "bezier",
          href: "de/bezier/",
          title: "Bézier",
          current: true,
          sections: [{ id: "hull", title: "In der <i>Hülle</i>" }],
        },
      ],
    },
  ],
};

describe("the shell", () => {
  test("fills every place of index.html, and takes braces of a page's text for text", () => {
    const html = shell(page);
    expect(html).toContain('<body class="lesson-page">\n<main>{{lang}} $& $1</main>\n</body>');
    expect(html.replace(page.body, "")).not.toMatch(/\{\{|biome/);
  });

  test("asks for the fonts of the first lines before the style sheets, without credentials", () => {
    const html = shell(page);
    const font =
      '<link rel="preload" as="font" type="font/woff2" href="../../assets/text.woff2" crossorigin>';
    expect(html).toContain(font);
    expect(html.indexOf(font)).toBeLessThan(html.indexOf("fonts.css"));
    expect(html).not.toMatch(/stylesheet"[^>]*crossorigin/);
  });

  test("escapes title and description", () => {
    const html = shell(page);
    expect(html).toContain("<title>Kurven &amp; Flächen · Straklatte</title>");
    expect(html).toContain('content="Sagt „&lt;b&gt;“ und &quot;so&quot;"');
  });

  test("says the site's name once on the front page", () => {
    expect(shell({ ...page, title: "Straklatte" })).toContain("<title>Straklatte</title>");
  });

  test("the policy comes before anything it governs", () => {
    const html = shell(page);
    const policy = html.indexOf("Content-Security-Policy");
    expect(policy).toBeGreaterThan(0);
    for (const later of ["<script", "<link"]) expect(html.indexOf(later)).toBeGreaterThan(policy);
    expect(shell({ ...page, csp: null })).not.toContain("Content-Security-Policy");
  });

  test("every address is relative to the root, and style sheets bear no crossorigin", () => {
    const html = shell({ ...page, chrome });
    for (const [, address] of html.matchAll(/ (?:href|src)="([^"]*)"/g)) {
      expect(address).toMatch(/^(\.\.\/\.\.\/|#|https:\/\/creativecommons\.org\/)/);
    }
    for (const [sheet] of html.matchAll(/<link rel="stylesheet"[^>]*>/g)) {
      expect(sheet).not.toContain("crossorigin");
    }
  });

  test("an unknown place in the template is an error that names it", () => {
    expect(() => shell(page, "<html>{{lnag}}</html>")).toThrow("{{lnag}}");
  });

  test("absolute addresses stand there only when they are given", () => {
    expect(shell(page)).not.toMatch(/canonical|hreflang|noindex/);
    const html = shell({
      ...page,
      noindex: true,
      canonical: "https://example.org/de/",
      alternates: [{ lang: "en", href: "https://example.org/en/" }],
    });
    expect(html).toContain('<link rel="canonical" href="https://example.org/de/">');
    expect(html).toContain('<link rel="alternate" hreflang="en" href="https://example.org/en/">');
    expect(html).toContain('<meta name="robots" content="noindex">');
  });
});

describe("the surroundings of a page", () => {
  const html = shell({ ...page, chrome });

  test("the other language's same page", () => {
    expect(html).toMatch(/<a class="tool language" href="\.\.\/\.\.\/en\/bezier\/" lang="en" hreflang="en"/);
  });

  test("the contents: parts, lessons, the current one marked, with its sections", () => {
    expect(html).toContain("Teil &lt;1&gt;");
    expect(html).toContain('<a href="../../de/bezier/" aria-current="page">Bézier</a>');
    expect(html).toContain('<a href="#hull">In der <i>Hülle</i></a>');
    expect(html.match(/aria-current/g)).toHaveLength(1);
  });

  test("every button has a name, and what it opens exists", () => {
    for (const [button] of html.matchAll(/<button.*?<\/button>/gs)) {
      const name = /aria-label="([^"]+)"/.exec(button)?.[1] ?? button.replace(/<[^>]*>/g, "").trim();
      expect(name, button).not.toBe("");
      const opens = /popovertarget="([^"]+)"/.exec(button)?.[1];
      if (opens) expect(html).toContain(`id="${opens}"`);
    }
  });
});
