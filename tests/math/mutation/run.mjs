// Mutation tests of src/math: `npm run test:mutation`, or `npm run test:mutation -- blossom nearest` for some files.
//
// Each mutant is a small change of a source file that some test ought to notice. A file is run against the test file of
// its own name, or of its topic (topics.json: test file → source files), or against all tests of the mathematics where it
// has neither.
// Everything takes an hour or two; results are kept in reports/mutation, and only what has changed since is run again. It
// fails if the tests did not run at all or if the score of all files together is below 85 %.
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, readFileSync } from "node:fs";

const stryker = "node_modules/@stryker-mutator/core/bin/stryker.js";
const wanted = process.argv.slice(2).map((name) => name.replace(/\.ts$/, ""));
const all = readdirSync("src/math")
  .filter((file) => file.endsWith(".ts") && file !== "index.ts")
  .map((file) => file.slice(0, -3));
const topics = JSON.parse(readFileSync("tests/math/mutation/topics.json", "utf8"));
mkdirSync("reports/mutation", { recursive: true });

const results = [];
for (const name of wanted.length === 0 ? all : wanted) {
  if (!existsSync(`src/math/${name}.ts`)) throw new Error(`src/math/${name}.ts: no such file to mutate`);
  const output = await mutate(name);
  // Some versions of the runner start no test for any mutant and call all of them survivors.
  if (/Ran 0\.00 tests per mutant/.test(output)) throw new Error(`${name}: no test ran against any mutant`);
  const [row] = output.matchAll(/^All files\s*\|.*$/gm);
  if (row) {
    const [, , , killed, timeout, survived, uncovered] = row[0].split("|").map(Number);
    const caught = killed + timeout;
    results.push({ name, caught, missed: survived + uncovered });
  } else if (!/Instrumented \d+ source file\(s\) with 0 mutant/.test(output)) {
    throw new Error(`${name}: no score in Stryker's output`);
  }
}

const score = ({ caught, missed }) => (100 * caught) / (caught + missed);
const total = results.reduce(
  (sum, { caught, missed }) => ({ caught: sum.caught + caught, missed: sum.missed + missed }),
  { caught: 0, missed: 0 },
);
for (const result of [...results, { name: "all files", ...total }]) {
  console.log(
    `${score(result).toFixed(1).padStart(6)} %  ${result.missed} survived of ${result.caught + result.missed}  ${result.name}`,
  );
}
process.exitCode = score(total) >= 85 ? 0 : 1;

/** Runs Stryker on one file and resolves to what it prints. */
function mutate(name) {
  const topic = Object.keys(topics).find((test) => topics[test].includes(name));
  const own = [name, topic].find((test) => test && existsSync(`tests/math/${test}.test.ts`));
  const tests = own ? `tests/math/${own}.test.ts` : "tests/math/**/*.test.ts";
  const child = spawn(
    process.execPath,
    [
      ...[stryker, "run", "tests/math/mutation/stryker.json"],
      ...["--mutate", `src/math/${name}.ts`, "--incrementalFile", `reports/mutation/${name}.json`],
    ],
    { env: { ...process.env, MUTATION_TESTS: tests }, stdio: ["ignore", "pipe", "inherit"] },
  );
  let text = "";
  child.stdout.on("data", (chunk) => {
    text += chunk;
    process.stdout.write(chunk);
  });
  return new Promise((resolve, reject) => {
    child.on("error", reject);
    child.on("close", (code) => {
      if (code === 0) resolve(text);
      else reject(new Error(`${name}: Stryker ended with code ${code}`));
    });
  });
}
