/** What stops the build: where, what, and how to mend it. */
export interface Problem {
  /** Path below the project's root. */
  readonly file: string;
  /** From 1. */
  readonly line: number;
  readonly message: string;
  readonly remedy: string;
}

/** One problem as a line of the terminal that editors can jump to. */
export function problemText({ file, line, message, remedy }: Problem): string {
  return `${file}:${line}: ${message}\n    → ${remedy}`;
}

/** All problems as one text, in the order of the files and lines. */
export function problemsText(problems: readonly Problem[]): string {
  const sorted = [...problems].sort((a, b) => a.file.localeCompare(b.file) || a.line - b.line);
  const count = problems.length === 1 ? "1 problem" : `${problems.length} problems`;
  return `${count} in the lessons\n\n${sorted.map(problemText).join("\n\n")}\n`;
}

/** The entry of a list that differs least from a misspelt word, for "did you mean"; null if none is near. */
export function nearest(word: string, list: readonly string[]): string | null {
  let best: string | null = null;
  let least = Math.max(2, Math.floor(word.length / 3)) + 1;
  for (const entry of list) {
    const distance = editDistance(word, entry);
    if (distance < least) [best, least] = [entry, distance];
  }
  return best;
}

/** "did you mean x? there are: a, b, c" */
export function choices(word: string, list: readonly string[]): string {
  const near = nearest(word, list);
  const all = list.length === 0 ? "there are none yet" : `there are: ${[...list].sort().join(", ")}`;
  return near === null ? all : `did you mean "${near}"? ${all}`;
}

/** Letters to insert, delete or replace to get from one word to the other. */
function editDistance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      next.push(Math.min(row[j]! + 1, next[j - 1]! + 1, row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1)));
    }
    row = next;
  }
  return row[b.length]!;
}
