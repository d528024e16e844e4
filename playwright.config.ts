import { defineConfig } from "@playwright/test";
import { type Browser, findBrowser } from "./tests/e2e/support/find-browser.ts";
import { freePort } from "./tests/e2e/support/free-port.ts";

// Each worker reads this file again: what the first one found goes on to the others by the environment.
process.env.STRAKLATTE_TEST_BROWSER ??= JSON.stringify(await findBrowser());
process.env.STRAKLATTE_TEST_PORT ??= String(await freePort());
const browser: Browser = JSON.parse(process.env.STRAKLATTE_TEST_BROWSER);
const port = process.env.STRAKLATTE_TEST_PORT;

export default defineConfig({
  testDir: "tests/e2e",
  testMatch: "**/*.spec.ts",
  workers: 2,
  fullyParallel: true,
  forbidOnly: true,
  retries: 0,
  timeout: 60_000,
  reporter: [["list"], ["json", { outputFile: "reports/browser.json" }]],
  outputDir: "test-results",
  use: {
    baseURL: `http://127.0.0.1:${port}/`,
    trace: "off",
    screenshot: "only-on-failure",
    launchOptions: {
      executablePath: browser.path,
      env: { ...process.env, ...browser.env },
      args: [
        "--no-sandbox",
        "--disable-gpu",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
      ],
    },
  },
  webServer: {
    command: "npx vite preview --host 127.0.0.1",
    env: { PORT: port },
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
    stdout: "ignore",
  },
});
