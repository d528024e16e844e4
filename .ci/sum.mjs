// Sums the reports of vitest and Playwright: the last line is "N passed, N failed". A report that is missing
// or holds no test counts as a failure, since then something did not run.
import { existsSync, readFileSync } from "node:fs";

const sum = { passed: 0, failed: 0, skipped: 0 };

for (const file of process.argv.slice(2)) {
  const counts = existsSync(file) ? read(JSON.parse(readFileSync(file, "utf8"))) : null;
  if (!counts || counts.passed + counts.failed === 0) {
    console.log(`${file}: no tests have run`);
    sum.failed++;
  } else {
    console.log(`${file}: ${line(counts)}`);
    for (const key of Object.keys(sum)) sum[key] += counts[key];
  }
}

console.log(line(sum));
process.exitCode = sum.failed > 0 ? 1 : 0;

function read(report) {
  if (report.stats) {
    const { expected, unexpected, flaky, skipped } = report.stats;
    return { passed: expected, failed: unexpected + flaky + report.errors.length, skipped };
  }
  const files = report.testResults.filter(
    (one) => one.status === "failed" && one.assertionResults.length === 0,
  );
  return {
    passed: report.numPassedTests,
    failed: report.numFailedTests + files.length,
    skipped: report.numPendingTests + report.numTodoTests,
  };
}

function line({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ""}`;
}
