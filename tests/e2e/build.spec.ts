import { createServer } from "node:http";
import { gzipSync } from "node:zlib";
import { expect, test } from "@playwright/test";
import { lessons, pages } from "./support/dist.ts";
import { freePort } from "./support/free-port.ts";
import { readThrough, watch, watchShifts } from "./support/watch.ts";

test("there are pages, and lessons among them", () => {
  expect(pages).toEqual(expect.arrayContaining(["", "de/", "en/", "de/bezier/", "en/bezier/"]));
  expect(lessons.length).toBeGreaterThanOrEqual(2);
});

for (const path of pages) {
  test(`/${path} comes to life without an error, a foreign request or a violation`, async ({
    page,
    baseURL,
  }) => {
    const seen = await watch(page, baseURL!);
    const shifts = await watchShifts(page);
    const answer = await page.goto(path);
    expect(answer!.status()).toBe(200);
    await page.waitForLoadState("networkidle");
    const figures = await readThrough(page);
    expect(figures).toBe(await page.locator("curve-demo[data-ready]").count());
    expect(await shifts()).toBeLessThanOrEqual(0.01);
    expect(seen).toEqual([]);
  });
}

for (const path of lessons) {
  test(`/${path} does not shift on a phone either`, async ({ browser, baseURL }) => {
    const context = await browser.newContext({ viewport: { width: 360, height: 740 }, baseURL: baseURL! });
    const page = await context.newPage();
    const shifts = await watchShifts(page);
    await page.goto(path);
    expect(await readThrough(page)).toBeGreaterThan(0);
    expect(await shifts()).toBeLessThanOrEqual(0.01);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide, "pixels that the page is wider than the phone").toBeLessThanOrEqual(0);
    await context.close();
  });

  test(`/${path} keeps its budget of text, style and fonts`, async ({ page }) => {
    const sizes = { text: 0, font: 0 };
    const kinds: Record<string, keyof typeof sizes> = {
      document: "text",
      stylesheet: "text",
      font: "font",
    };
    const pending: Promise<void>[] = [];
    page.on("response", (response) => {
      const kind = kinds[response.request().resourceType()];
      if (!kind) return;
      pending.push(
        response.body().then((body) => {
          sizes[kind] += kind === "font" ? body.length : gzipSync(body).length;
        }),
      );
    });
    await page.goto(path);
    await readThrough(page);
    await page.waitForLoadState("networkidle");
    await Promise.all(pending);
    expect(sizes.text).toBeGreaterThan(10_000);
    // The still picture of a surface is some hundred shaded facets: such a lesson may be twice as heavy.
    const surfaces = await page.locator("curve-demo > svg .facets").count();
    expect(sizes.text).toBeLessThanOrEqual(surfaces > 0 ? 160_000 : 80_000);
    expect(sizes.font).toBeGreaterThan(10_000);
    expect(sizes.font).toBeLessThanOrEqual(130_000);
  });
}

test("what is not there is answered by a page that needs nothing else", async ({ page, baseURL }) => {
  const seen: string[] = [];
  page.on("request", (request) => seen.push(request.url()));
  const answer = await page.goto("de/no/such/page/?a=1");
  expect(answer!.status()).toBe(404);
  await expect(page.locator("h1")).toBeVisible();
  await page.waitForLoadState("networkidle");
  expect(seen.filter((url) => !url.startsWith("data:"))).toEqual([`${baseURL}de/no/such/page/?a=1`]);
  const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  expect(background, "its own style sheet is allowed by the policy").not.toBe("rgba(0, 0, 0, 0)");
});

test("a folder without its slash leads to the page, with its query", async ({ page, baseURL }) => {
  await page.goto("embed/bezier-curve?t=0.25");
  expect(page.url()).toBe(`${baseURL}embed/bezier-curve/?t=0.25`);
});

test("embed.js makes a figure on a page of another origin", async ({ page, baseURL }) => {
  const seen: string[] = [];
  page.on("pageerror", (error) => seen.push(error.message));
  page.on("requestfailed", (request) => seen.push(request.url()));
  const host = createServer((_, response) => {
    response.setHeader("Content-Type", "text/html");
    response.end(`<!doctype html><title>slides</title><script type="module" src="${baseURL}embed.js"></script>
      <curve-demo demo="bezier-curve" t="0.25" lang="en" style="display:block;width:600px"></curve-demo>`);
  });
  const port = await freePort();
  await new Promise<void>((resolve) => host.listen(port, "127.0.0.1", resolve));
  await page.goto(`http://127.0.0.1:${port}/`);
  await page.locator("curve-demo[data-ready]").waitFor();
  const state = await page
    .locator("curve-demo")
    .evaluate((figure) => (figure as HTMLElement & { state: unknown }).state);
  expect(state).toMatchObject({ t: 0.25 });
  expect(seen).toEqual([]);
  host.close();
});
