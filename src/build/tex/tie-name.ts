import type { FigureNames } from "./figure-names.ts";

/**
 * The name that a symbol is tied to in a figure: `points.i` with i = 2 is `points.2`, with i = n `points.n` (the last one,
 * however many there are), with any other index `points.*`, all of them. null if the figure has nothing like it.
 *
 * Computed values that nothing shows count only where the author asks for them (`values`).
 */
export function tieName(
  form: string,
  letters: ReadonlyMap<string, string>,
  { names, value }: FigureNames,
  values = false,
): string | null {
  // The degree above B_i^n must be the figure's own: other degrees are other polynomials.
  const free = [...letters].filter(([letter]) => !form.split(".").includes(letter));
  if (free.some(([, index]) => !/^(n|\d+)$/.test(index))) return null;
  const parts = form.split(".");
  const segments = parts.map((part, k) =>
    letters.has(part) ? indexSegment(letters.get(part)!, k === parts.length - 1) : part,
  );
  const flat = flattened(segments, value);
  const name = flat.join(".");
  const known = [...names].filter(([, thing]) => values || thing.seen).map(([key]) => key);
  if (flat.some((segment, k) => isMany(segment, k))) {
    return known.some((key) => matches(flat, key.split("."))) ? name : null;
  }
  return known.includes(name) ? name : null;
}

/** Of n, the last one, a figure knows how many it is where the things are counted, at the end of the name. */
function indexSegment(text: string, atEnd: boolean): string {
  return /^\d+$/.test(text) || (atEnd && /^n(-\d+)?$/.test(text)) ? text : "*";
}

/** The points of a net stand in one row: point (i, j) has the number i · columns + j. */
function flattened(segments: readonly string[], value: FigureNames["value"]): readonly string[] {
  const [param, i, j] = segments;
  if (segments.length !== 3) return segments;
  const rows = value(param!);
  const isNet = Array.isArray(rows) && Array.isArray(rows[0]) && Array.isArray(rows[0][0]);
  if (!isNet || param === "levels") return segments;
  if (!/^\d+$/.test(i!) || !/^\d+$/.test(j!)) return [param!, "*"];
  return [param!, String(Number(i) * (rows[0] as unknown[]).length + Number(j))];
}

/** A name of its own may be n, the normal; behind a point, n is the last one. */
function isMany(segment: string, place: number): boolean {
  return place > 0 && /^(\*|n(-\d+)?)$/.test(segment);
}

function matches(pattern: readonly string[], name: readonly string[]): boolean {
  return (
    pattern.length === name.length &&
    pattern.every((segment, k) => (isMany(segment, k) ? /^\d+$/.test(name[k]!) : segment === name[k]))
  );
}
