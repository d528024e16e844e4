// `npm run bench`: bundles the benchmark in memory, runs it in this process, prints ratios and writes nothing.
import { createRequire } from "node:module";
import { Bezier } from "bezier-js";
import * as three from "three";
import { build } from "vite";

const require = createRequire(import.meta.url);
const peers = { Bezier, three, verb: require("verb-nurbs-web"), nurbs: require("nurbs") };

const { output } = await build({
  configFile: false,
  logLevel: "warn",
  build: { ssr: "bench/report.ts", write: false, target: "es2022", minify: false },
});
const code = Buffer.from(output[0].code).toString("base64");
const { report } = await import(`data:text/javascript;base64,${code}`);
process.exitCode = report(peers, console.log) ? 0 : 1;
