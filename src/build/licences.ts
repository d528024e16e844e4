import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

/** Names of the packages that the given modules and files come from. */
export function packagesOf(files: Iterable<string>): string[] {
  const names = new Set<string>();
  for (const file of files) {
    const found = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file.replaceAll("\\", "/"));
    if (found) names.add(found[1]!);
  }
  return [...names].sort();
}

/**
 * The licences of everything that the site ships, word for word.
 *
 * @throws Error if a package brings no licence.
 */
export function licencesText(root: string, packages: readonly string[]): string {
  const head = [
    "Straklatte: program under the MIT licence, text and pictures under CC BY 4.0",
    "(https://creativecommons.org/licenses/by/4.0/).",
    "",
    "The site ships parts of these packages:",
    ...packages.map((name) => `  ${name} ${about(root, name)}`),
  ];
  const texts = packages.map((name) => `\n${"-".repeat(78)}\n${name}\n\n${licenceOf(root, name).trim()}\n`);
  return `${head.join("\n")}\n${texts.join("")}`;
}

function about(root: string, name: string): string {
  const { version, license } = JSON.parse(
    readFileSync(join(root, "node_modules", name, "package.json"), "utf8"),
  ) as { version: string; license?: string };
  return `${version} (${license ?? "see below"})`;
}

function licenceOf(root: string, name: string): string {
  const folder = join(root, "node_modules", name);
  const file = existsSync(folder)
    ? readdirSync(folder).find((entry) => /^licen[cs]e/i.test(entry))
    : undefined;
  if (!file) throw new Error(`the package "${name}" brings no licence; it cannot be shipped`);
  return readFileSync(join(folder, file), "utf8");
}
