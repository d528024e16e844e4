import type { Page } from "@playwright/test";

/** What a graphics card made of software says about its speed; no page can help it. */
const NOISE = /GL Driver Message \(OpenGL, Performance/;

/** Everything of a visit that should not be: errors, warnings of the console, foreign requests, violations. */
export async function watch(page: Page, origin: string): Promise<readonly string[]> {
  const seen: string[] = [];
  page.on("console", (message) => {
    const serious = message.type() === "error" || message.type() === "warning";
    if (serious && !NOISE.test(message.text())) {
      seen.push(`console: ${message.text()}`);
    }
  });
  page.on("pageerror", (error) => seen.push(`error: ${error.message}`));
  page.on("requestfailed", (request) => seen.push(`failed: ${request.url()}`));
  page.on("response", (response) => {
    if (response.status() >= 400) seen.push(`${response.status()}: ${response.url()}`);
  });
  page.on("request", (request) => {
    const { protocol } = new URL(request.url());
    const own = request.url().startsWith(origin) || protocol === "data:" || protocol === "blob:";
    if (!own) seen.push(`foreign: ${request.url()}`);
  });
  await page.exposeFunction("reportViolation", (text: string) => seen.push(`violation: ${text}`));
  await page.addInitScript(() => {
    addEventListener("securitypolicyviolation", (event) => {
      const { effectiveDirective, blockedURI, sample } = event;
      (globalThis as unknown as { reportViolation(text: string): void }).reportViolation(
        `${effectiveDirective} ${blockedURI} ${sample}`,
      );
    });
  });
  return seen;
}

/** Adds up how far things moved by themselves (cumulative layout shift), from the first paint on. */
export async function watchShifts(page: Page): Promise<() => Promise<number>> {
  await page.addInitScript(() => {
    const sum = globalThis as unknown as { shifts: number };
    sum.shifts = 0;
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries() as unknown as Shift[]) {
        if (!entry.hadRecentInput) sum.shifts += entry.value;
      }
    }).observe({ type: "layout-shift", buffered: true });
    interface Shift extends PerformanceEntry {
      readonly value: number;
      readonly hadRecentInput: boolean;
    }
  });
  return () => page.evaluate(() => (globalThis as unknown as { shifts: number }).shifts);
}

/** Reads the page from top to end, as long as it takes each figure to come to life; gives their number. */
export async function readThrough(page: Page): Promise<number> {
  await page.evaluate(async () => {
    const pause = () => new Promise((resolve) => setTimeout(resolve, 60));
    for (let y = 0; y < document.documentElement.scrollHeight; y += innerHeight * 0.8) {
      scrollTo({ top: y, behavior: "instant" });
      await pause();
    }
  });
  const count = await page.locator("curve-demo").count();
  for (let i = 0; i < count; i++) {
    const figure = page.locator("curve-demo").nth(i);
    await figure.evaluate((element) => element.scrollIntoView({ block: "center", behavior: "instant" }));
    await figure.and(page.locator("[data-ready]")).waitFor();
  }
  return count;
}
