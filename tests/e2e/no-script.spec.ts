import { pathToFileURL } from "node:url";
import { expect, type Page, test } from "@playwright/test";
import { DIST, lessons, readFile } from "./support/dist.ts";

/** The lesson as a reader meets it who has no scripts: headings, formulas, pictures, captions. */
async function expectComplete(page: Page, path: string): Promise<void> {
  const source = readFile(`${path}index.html`);
  const seen = await page.evaluate(() => {
    const main = document.querySelector("main")!;
    const size = (element: Element | null) => {
      const { width = 0, height = 0 } = element?.getBoundingClientRect() ?? {};
      return { width, height };
    };
    return {
      headings: [...main.querySelectorAll("h1, h2, h3")].map(size),
      formulas: main.querySelectorAll(".katex-mathml math").length,
      // Captions for paper, answers, spare symbols of live formulas show when they are asked for.
      boxes: [...main.querySelectorAll(".katex-html")]
        .filter((box) => !box.closest(".on-paper, details:not([open]), [popover], .glyphs"))
        .map(size),
      figures: [...main.querySelectorAll("figure:has(curve-demo)")].map((figure) => ({
        picture: size(figure.querySelector("curve-demo > svg")),
        strokes: figure.querySelectorAll("curve-demo > svg :is(path, circle, rect, image)").length,
        caption: size(figure.querySelector("figcaption")),
      })),
    };
  });
  const body = source.slice(source.indexOf("<main"));
  expect(seen.headings.length).toBeGreaterThan(3);
  for (const { width, height } of seen.headings) expect(Math.min(width, height)).toBeGreaterThan(10);
  expect(seen.formulas).toBe(body.match(/<math /g)?.length);
  for (const { width, height } of seen.boxes) expect(Math.min(width, height)).toBeGreaterThan(2);
  expect(seen.figures.length).toBe(body.match(/<curve-demo /g)?.length);
  expect(seen.figures.length).toBeGreaterThan(0);
  for (const { picture, strokes, caption } of seen.figures) {
    expect(picture.width).toBeGreaterThan(200);
    expect(picture.height).toBeGreaterThan(100);
    expect(strokes).toBeGreaterThan(3);
    expect(caption.height).toBeGreaterThan(10);
  }
}

for (const path of lessons) {
  test.describe(`/${path}`, () => {
    test.use({ javaScriptEnabled: false });

    test("reads completely without scripts", async ({ page }) => {
      await page.goto(path);
      await expectComplete(page, path);
    });
  });

  test(`/${path} reads completely when it is opened from disk`, async ({ page }) => {
    await page.goto(pathToFileURL(`${DIST}/${path}index.html`).href);
    await expectComplete(page, path);
    const font = await page.evaluate(() => getComputedStyle(document.querySelector("h1")!).fontFamily);
    expect(font, "the style sheet is found").toContain("Source Serif 4");
  });
}
