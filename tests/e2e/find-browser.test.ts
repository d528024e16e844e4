import { chromium } from "@playwright/test";
import { afterEach, expect, test } from "vitest";
import { findBrowser } from "./support/find-browser.ts";

const given = process.env.CHROME_PATH;

afterEach(() => {
  if (given === undefined) delete process.env.CHROME_PATH;
  else process.env.CHROME_PATH = given;
});

test("CHROME_PATH that leads to no browser is an error that says what to do", async () => {
  process.env.CHROME_PATH = process.execPath;
  await expect(findBrowser()).rejects.toThrow(/CHROME_PATH=.* does not start; let it name a Chrome/);
});

test.runIf(process.platform === "linux" && process.arch === "x64")(
  "where no browser is installed, the one of the packages runs, with letters and WebGL",
  async () => {
    const { path, env } = await findBrowser({ installed: false });
    expect(path).toContain("node_modules");
    const browser = await chromium.launch({
      executablePath: path,
      env: { ...process.env, ...env } as Record<string, string>,
      args: ["--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
    try {
      const page = await browser.newPage();
      await page.setContent("<p style='display:inline-block'>Kurve ä</p>");
      const seen = await page.evaluate(() => ({
        width: document.querySelector("p")!.getBoundingClientRect().width,
        webgl: document.createElement("canvas").getContext("webgl2") !== null,
      }));
      expect(seen.width).toBeGreaterThan(20);
      expect(seen.webgl).toBe(true);
    } finally {
      await browser.close();
    }
  },
  120_000,
);
