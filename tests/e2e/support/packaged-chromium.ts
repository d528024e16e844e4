import { existsSync, mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Browser } from "./find-browser.ts";

const PACKAGE = join(import.meta.dirname, "../../../node_modules/@sparticuz/chromium");

/**
 * The Chromium that the package @sparticuz/chromium brings, unpacked once into a folder of its own; null if
 * it does not run on this machine. Its own libraries are used only where the machine lacks them.
 */
export async function packagedChromium(starts: (browser: Browser) => boolean): Promise<Browser | null> {
  if (process.platform !== "linux" || process.arch !== "x64" || !existsSync(PACKAGE)) return null;
  const { version } = JSON.parse(readFileSync(join(PACKAGE, "package.json"), "utf8")) as { version: string };
  const cache = join(PACKAGE, "../../.cache/straklatte");
  const folder = join(cache, `chromium-${version}`);
  if (!existsSync(folder)) await unpack(cache, folder);
  const path = join(folder, "chromium");
  const libraries = [join(folder, "al2023/lib"), process.env.LD_LIBRARY_PATH].filter(Boolean).join(":");
  const fonts = { FONTCONFIG_FILE: join(folder, "fonts.conf") };
  const ways = [
    { path, env: fonts },
    { path, env: { ...fonts, LD_LIBRARY_PATH: libraries } },
  ];
  return ways.find(starts) ?? null;
}

/** The package unpacks into the system's temporary folder, and its libraries only in certain clouds. */
async function unpack(cache: string, folder: string): Promise<void> {
  const half = `${folder}.${process.pid}`;
  mkdirSync(half, { recursive: true });
  const kept = { ...process.env };
  Object.assign(process.env, { TMPDIR: half, AWS_LAMBDA_JS_RUNTIME: "nodejs20.x" });
  try {
    const { default: chromium } = await import("@sparticuz/chromium");
    await chromium.executablePath();
  } finally {
    for (const name of ["TMPDIR", "AWS_LAMBDA_JS_RUNTIME", "LD_LIBRARY_PATH", "FONTCONFIG_PATH", "HOME"]) {
      if (kept[name] === undefined) delete process.env[name];
      else process.env[name] = kept[name];
    }
  }
  writeFileSync(join(half, "fonts.conf"), fontsConf(folder));
  mkdirSync(cache, { recursive: true });
  if (existsSync(folder)) rmSync(half, { recursive: true });
  else renameSync(half, folder);
}

/** The machine's fonts, if it has any, and those of the package, whose own list names other folders. */
function fontsConf(folder: string): string {
  return `<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <include ignore_missing="yes">/etc/fonts/fonts.conf</include>
  <dir>${folder}/fonts/fonts</dir>
  <cachedir>${folder}/fonts-cache</cachedir>
</fontconfig>
`;
}
