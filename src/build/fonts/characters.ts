/** What the pages and scripts may show, as sets of characters. */
export interface Characters {
  readonly text: ReadonlySet<number>;
  readonly formulas: ReadonlySet<number>;
}

/** Figures and readouts may write any of these at any time: letters and digits of labels, numbers, signs. */
const ALWAYS = Array.from({ length: 95 }, (_, i) => String.fromCharCode(32 + i)).join("");
const ALWAYS_TEXT = `${ALWAYS} ÄÖÜäöüßéèàçóë„“”‚‘’–—…−×·°±≤≥½¼¾§«»`;
const ALWAYS_FORMULA = `${ALWAYS}−′·…αβγδεζηθκλμνξπρστφχψω`;

/**
 * Gathers the characters of all documents and scripts. Of a script all that is not ASCII counts, since words
 * stand in it as they are. What is only heard (MathML) needs no font.
 */
export function gatherCharacters(pages: Iterable<string>, scripts: Iterable<string>): Characters {
  const text = new Set<number>();
  const formulas = new Set<number>();
  add(text, ALWAYS_TEXT);
  add(formulas, ALWAYS_FORMULA);
  for (const page of pages) {
    const seen = decode(page.replace(/<math[\s>].*?<\/math>/gs, "").replace(/<[^>]*>/g, " "));
    add(text, seen);
    add(formulas, seen);
  }
  for (const script of scripts) {
    const words = script.replace(/\\u([0-9a-f]{4})/gi, (_, code) => String.fromCharCode(parseInt(code, 16)));
    add(text, words, 128);
    add(formulas, words, 128);
  }
  return { text, formulas };
}

function add(set: Set<number>, words: string, from = 0): void {
  for (const char of words) {
    const code = char.codePointAt(0)!;
    if (code >= from) set.add(code);
  }
}

function decode(html: string): string {
  return html.replace(/&#(x?)([0-9a-f]+);/gi, (_, hex, code) =>
    String.fromCodePoint(parseInt(code, hex ? 16 : 10)),
  );
}

/** Whether a face is asked for a character, by its `unicode-range`. */
export function inRange(code: number, range: string): boolean {
  if (range === "") return true;
  return range.split(",").some((part) => {
    const [from, to = from] = part.slice(2).split("-");
    return code >= parseInt(from!, 16) && code <= parseInt(to!, 16);
  });
}

/** Ascending codes as a `unicode-range`: U+20-7E,U+C4. */
export function writeRange(codes: readonly number[]): string {
  const parts: string[] = [];
  for (let i = 0; i < codes.length; i++) {
    const from = codes[i]!;
    while (codes[i + 1] === codes[i]! + 1) i++;
    const hex = (code: number) => code.toString(16).toUpperCase();
    parts.push(codes[i] === from ? `U+${hex(from)}` : `U+${hex(from)}-${hex(codes[i]!)}`);
  }
  return parts.join(",");
}
