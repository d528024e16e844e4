import { parseSync } from "vite";

/** The lines between `{` and `}` of a function, or of a marked region, moved to the left; null if not found. */
export function sourceLines(source: string, name: string): string[] | null {
  return regionLines(source, name) ?? bodyLines(source, name);
}

function regionLines(source: string, name: string): string[] | null {
  const lines = source.split("\n");
  const start = lines.findIndex((line) => line.trim() === `// #region ${name}`);
  if (start < 0) return null;
  const end = lines.findIndex((line, i) => i > start && line.trim() === "// #endregion");
  return end < 0 ? null : outdent(lines.slice(start + 1, end));
}

function bodyLines(source: string, name: string): string[] | null {
  const body = findBody(parseSync("source.ts", source).program, name);
  return body && outdent(source.slice(body.start + 1, body.end - 1).split("\n"));
}

/** As much of a syntax tree's node as is looked at. */
interface Node {
  readonly type: string;
  readonly start: number;
  readonly end: number;
  readonly name?: string;
  readonly id?: Node | null;
  readonly init?: Node | null;
  readonly body?: Node | null;
}

/** Looks for `function name() {…}` or `name = () => {…}` anywhere in the syntax tree. */
function findBody(tree: unknown, name: string): Node | null {
  if (typeof tree !== "object" || tree === null) return null;
  const { type, id, body, init } = tree as Partial<Node>;
  if (type === "FunctionDeclaration" && id?.name === name) return body ?? null;
  if (type === "VariableDeclarator" && id?.name === name && init?.body?.type === "BlockStatement")
    return init.body;
  for (const entry of Object.values(tree)) {
    const found = findBody(entry, name);
    if (found) return found;
  }
  return null;
}

function outdent(lines: readonly string[]): string[] {
  const full = lines.filter((line) => line.trim() !== "");
  const depth = Math.min(...full.map((line) => line.length - line.trimStart().length));
  const moved = lines.map((line) => line.slice(depth).trimEnd());
  while (moved[0] === "") moved.shift();
  while (moved.at(-1) === "") moved.pop();
  return moved;
}
