import type { Locator, Page } from "@playwright/test";

/** The state of a figure, as its property gives it. */
export function stateOf(figure: Locator): Promise<Record<string, unknown>> {
  return figure.evaluate((element) => (element as HTMLElement & { state: Record<string, unknown> }).state);
}

/** A figure of the page that has come to life; the page is scrolled to it. */
export async function alive(page: Page, selector = "curve-demo"): Promise<Locator> {
  const figure = page.locator(selector).first();
  await figure.scrollIntoViewIfNeeded();
  await page.locator(`${selector}[data-ready]`).first().waitFor();
  return figure;
}

/** The middle of an element on the screen. */
export async function middleOf(locator: Locator): Promise<{ x: number; y: number }> {
  const box = await locator.boundingBox();
  if (!box) throw new Error("the element has no box: it is not on the screen");
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Drags with the mouse from an element by so many pixels. */
export async function dragBy(page: Page, from: Locator, dx: number, dy: number): Promise<void> {
  const { x, y } = await middleOf(from);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 3 });
  await page.mouse.move(x + dx, y + dy, { steps: 3 });
  await page.mouse.up();
}

/** Serves a page of the test's own from the site's origin, as a host of figures. */
export async function hostPage(page: Page, body: string): Promise<void> {
  await page.route("**/host-of-the-test.html", (route) =>
    route.fulfill({
      contentType: "text/html",
      body: `<!doctype html><html lang="en"><meta charset="utf-8"><title>host</title><body>${body}</body></html>`,
    }),
  );
  await page.goto("/host-of-the-test.html");
}
