/** What the lesson's glossary says of a symbol, as nodes of one's own; null if it says nothing. */
export function meaningOf(entry: string | null | undefined): Node[] | null {
  const row = entry ? document.getElementById(`symbol-${entry}`)?.querySelector("dd") : null;
  return row ? [...row.childNodes].map((node) => node.cloneNode(true)) : null;
}
