// `npm run build:math`: writes src/math as a package of its own to dist-math/, or to the folder given as argument.
import { execFileSync } from "node:child_process";
import { copyFileSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";

const out = resolve(process.argv[2] ?? "dist-math");
rmSync(out, { recursive: true, force: true });
execFileSync(
  process.execPath,
  ["node_modules/typescript/bin/tsc", "-p", "tsconfig.math.json", "--outDir", out],
  {
    stdio: "inherit",
  },
);
// The compiler rewrites the extension of imports in modules, but leaves it in declarations.
for (const file of readdirSync(out).filter((name) => name.endsWith(".d.ts"))) {
  const text = readFileSync(join(out, file), "utf8");
  writeFileSync(join(out, file), text.replaceAll(/(["']\.\/[\w-]+)\.ts(["'])/g, "$1.js$2"));
}
const { version } = JSON.parse(readFileSync("package.json", "utf8"));
const description = JSON.parse(readFileSync("src/math/package.json", "utf8"));
writeFileSync(join(out, "package.json"), `${JSON.stringify({ ...description, version }, null, 2)}\n`);
copyFileSync("src/math/README.md", join(out, "README.md"));
copyFileSync("LICENSE", join(out, "LICENSE"));
