import { choices, type Problem } from "./problem.ts";

/** A value of the front matter, and its line. */
interface Entry<T> {
  readonly value: T;
  readonly line: number;
}

/** What stands above a lesson's text. */
export interface FrontMatter {
  readonly title: string;
  /** The title in the navigation, if the full one is long. */
  readonly short: string;
  /** One or two sentences: what the lesson is about. Markdown. */
  readonly lead: Entry<string>;
  /** For search engines and links, without any markup. */
  readonly description: string;
  readonly minutes: number;
  /** Markdown, one a goal. */
  readonly goals: readonly Entry<string>[];
  /** Ids of the lessons to have read. */
  readonly prerequisites: readonly Entry<string>[];
  /** Whether the whole lesson goes beyond the scripts. */
  readonly addition: boolean;
}

const KEYS = ["title", "short", "lead", "description", "minutes", "goals", "prerequisites", "addition"];

/**
 * Splits a lesson into front matter and text. The text keeps its line numbers: the front matter is replaced
 * by empty lines. A lesson whose front matter cannot be used gives `null` and the reasons.
 */
export function splitFrontMatter(
  file: string,
  source: string,
): { readonly front: FrontMatter | null; readonly text: string; readonly problems: Problem[] } {
  const lines = source.replace(/\r\n?/g, "\n").split("\n");
  const end = lines[0] === "---" ? lines.indexOf("---", 1) : -1;
  if (end < 0) {
    const problem = {
      file,
      line: 1,
      message: "the front matter is missing",
      remedy:
        'start the file with "---", lines "title: …", "lead: …", "minutes: …", "goals:", and "---" again',
    };
    return { front: null, text: source, problems: [problem] };
  }
  const problems: Problem[] = [];
  const entries = readEntries(file, lines.slice(0, end), problems);
  const front = checkEntries(file, entries, problems);
  const text = [...lines.slice(0, end + 1).fill(""), ...lines.slice(end + 1)].join("\n");
  return { front: problems.length === 0 ? front : null, text, problems };
}

type Entries = Map<string, { line: number; value: string; items: Entry<string>[] }>;

/** `key: value`, or `key:` with `- item` lines below; an indented line goes on with the one before. */
function readEntries(file: string, lines: readonly string[], problems: Problem[]): Entries {
  const entries: Entries = new Map();
  let last: { line: number; value: string; items: { line: number; value: string }[] } | undefined;
  for (const [i, text] of lines.entries()) {
    const line = i + 1;
    if (i === 0 || text.trim() === "") continue;
    const key = /^([a-z]+):\s*(.*)$/.exec(text);
    const item = /^\s*-\s+(.*)$/.exec(text);
    const more = /^\s+(\S.*)$/.exec(text);
    if (key) {
      if (entries.has(key[1]!)) {
        problems.push({ file, line, message: `"${key[1]}" is given twice`, remedy: "keep one of the two" });
      }
      last = { line, value: key[2]!.trim(), items: [] };
      entries.set(key[1]!, last);
    } else if (item && last) {
      last.items.push({ line, value: item[1]!.trim() });
    } else if (more && last) {
      const target = last.items.at(-1) ?? last;
      target.value = `${target.value} ${more[1]!.trim()}`.trim();
    } else {
      problems.push({
        file,
        line,
        message: `this line of the front matter is no "key: value": ${text}`,
        remedy: 'write "key: value", or "- item" below a key, or indent it to go on with the line before',
      });
    }
  }
  return entries;
}

function checkEntries(file: string, entries: Entries, problems: Problem[]): FrontMatter {
  const report = (line: number, message: string, remedy: string) =>
    problems.push({ file, line, message, remedy });
  for (const [key, { line }] of entries) {
    if (!KEYS.includes(key)) report(line, `unknown entry "${key}" in the front matter`, choices(key, KEYS));
  }
  const need = (key: string): Entry<string> => {
    const found = entries.get(key);
    if (!found?.value) report(found?.line ?? 1, `the front matter has no "${key}"`, `add a line "${key}: …"`);
    return { value: found?.value ?? "", line: found?.line ?? 1 };
  };
  const list = (key: string): readonly Entry<string>[] => {
    const found = entries.get(key);
    if (found?.value) report(found.line, `"${key}" is a list`, `write "${key}:" and below it "- …" lines`);
    return found?.items ?? [];
  };
  const title = need("title").value;
  const lead = need("lead");
  const minutes = need("minutes");
  if (minutes.value && !/^[1-9]\d{0,2}$/.test(minutes.value)) {
    report(minutes.line, `"minutes" is no whole number: ${minutes.value}`, 'write "minutes: 45"');
  }
  const goals = list("goals");
  if (goals.length === 0) report(entries.get("goals")?.line ?? 1, 'the lesson has no "goals"', "list some");
  const addition = entries.get("addition");
  if (addition && !["yes", "no"].includes(addition.value)) {
    report(addition.line, `"addition" is neither yes nor no: ${addition.value}`, 'write "addition: yes"');
  }
  return {
    title,
    short: entries.get("short")?.value || title,
    lead,
    description: entries.get("description")?.value || plain(lead.value),
    minutes: Number(minutes.value),
    goals,
    prerequisites: list("prerequisites"),
    addition: addition?.value === "yes",
  };
}

/** A sentence of markdown without its signs. */
function plain(markdown: string): string {
  return markdown.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").replace(/[*_$`\\]/g, "");
}
