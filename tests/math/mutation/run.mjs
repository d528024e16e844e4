// Mutation tests of src/math: `npm run test:mutation`, or `npm run test:mutation -- blossom nearest` for some files.
//
// Each mutant is a small change of a source file that some test ought to notice. The run takes hours for everything;
// results are kept in reports/mutation, and only what has changed since is run again. It fails if a file's tests did
// not run at all or if the score of all files together is below 85 %.
import { spawn } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";

const wanted = process.argv.slice(2);
const all = readdirSync("src/math").filter((file) => file.endsWith(".ts") && file !== "index.ts");
const files = wanted.length === 0 ? all : wanted.map((name) => `${name.replace(/\.ts$/, "")}.ts`);
for (const file of files) {
  if (!existsSync(`src/math/${file}`)) throw new Error(`src/math/${file}: no such file to mutate`);
}

const output = await new Promise((resolve, reject) => {
  const mutate = files.map((file) => `src/math/${file}`).join(",");
  const incremental = "reports/mutation/incremental.json";
  const options = [
    "run",
    "tests/math/mutation/stryker.json",
    "--mutate",
    mutate,
    "--incrementalFile",
    incremental,
  ];
  const stryker = spawn(process.execPath, ["node_modules/@stryker-mutator/core/bin/stryker.js", ...options], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  let text = "";
  stryker.stdout.on("data", (chunk) => {
    text += chunk;
    process.stdout.write(chunk);
  });
  stryker.on("error", reject);
  stryker.on("close", (code) =>
    code === 0 ? resolve(text) : reject(new Error(`Stryker ended with code ${code}`)),
  );
});

// With its related tests switched off, a version of the runner reports survivors that no test has ever met.
if (/Ran 0\.00 tests per mutant/.test(output)) {
  throw new Error("No test ran against any mutant: the runner does not work with this version of vitest");
}
const rows = [...output.matchAll(/^\s*(All files|[\w-]+\.ts)\s*\|\s*([\d.]+)/gm)];
if (rows.length === 0) throw new Error("No score in Stryker's output");
const scores = rows.map(([, file, score]) => ({ file, score: Number(score) }));
for (const { file, score } of scores) {
  if (score < 85) console.log(`${file}: ${score} % is below 85 %`);
}
process.exitCode = scores.every(({ file, score }) => file !== "All files" || score >= 85) ? 0 : 1;
