import { execFileSync, spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { packagedChromium } from "./packaged-chromium.ts";

/** How to start a browser. */
export interface Browser {
  readonly path: string;
  /** Variables it needs beside ours. */
  readonly env: Readonly<Record<string, string>>;
}

const NAMES = ["google-chrome-stable", "google-chrome", "chromium", "chromium-browser", "chrome", "msedge"];

const PLACES = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
  "C:\\Program Files (x86)\\Google\\Chrome\\Application\\chrome.exe",
  "/opt/google/chrome/chrome",
  "/snap/bin/chromium",
];

/**
 * The browser of the tests: `CHROME_PATH`, else an installed Chrome or Chromium, else the one that the
 * development packages bring. With `installed: false` only the last.
 *
 * @throws Error that says what to install if none starts.
 */
export async function findBrowser(options: { readonly installed?: boolean } = {}): Promise<Browser> {
  const { installed = true } = options;
  const asked = process.env.CHROME_PATH;
  if (installed && asked) {
    if (starts({ path: asked, env: {} })) return { path: asked, env: {} };
    throw new Error(`CHROME_PATH=${asked} does not start; let it name a Chrome or Chromium, or unset it`);
  }
  const found = installed ? [...onPath(), ...PLACES.filter((place) => existsSync(place))] : [];
  for (const path of found) {
    if (starts({ path, env: {} })) return { path, env: {} };
  }
  const own = await packagedChromium(starts);
  if (own) return own;
  throw new Error(
    "no browser starts: install Chrome or Chromium, or let CHROME_PATH name one. (The one in node_modules, " +
      "@sparticuz/chromium, runs on Linux x64 only.)",
  );
}

function onPath(): string[] {
  return NAMES.flatMap((name) => {
    try {
      const which = process.platform === "win32" ? "where" : "which";
      return execFileSync(which, [name], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] })
        .split("\n", 1)
        .filter((line) => line !== "");
    } catch {
      return [];
    }
  });
}

/** Whether the program runs and is a Chromium. */
function starts({ path, env }: Browser): boolean {
  const run = spawnSync(path, ["--version", "--no-sandbox"], {
    encoding: "utf8",
    timeout: 20_000,
    env: { ...process.env, ...env },
  });
  return run.status === 0 && /chrom/i.test(run.stdout);
}
