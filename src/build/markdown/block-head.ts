/** The first line of a block, taken apart: `::: demo bezier-curve {#fig t=0.25}`. */
export interface BlockHead {
  readonly name: string;
  /** What stands between name and braces. */
  readonly args: string;
  readonly id: string | null;
  /** In the order written. */
  readonly attributes: ReadonlyMap<string, string>;
}

/** Reads what follows the colons; a text is the reason why it cannot be read. */
export function readBlockHead(text: string): BlockHead | string {
  const parts = /^\s*([^\s{]+)\s*(.*?)\s*(?:\{([^{}]*)\}\s*)?$/.exec(text);
  if (!parts) return "no name follows the colons";
  const [, name, args, braces = ""] = parts;
  const attributes = new Map<string, string>();
  let id: string | null = null;
  for (const [piece] of braces.matchAll(/[^\s"]+(?:"[^"]*")?|"[^"]*"/g)) {
    const pair = /^([^=#.]+)(?:=(?:"([^"]*)"|([^"]*)))?$/.exec(piece);
    if (piece.startsWith("#") && piece.length > 1 && id === null) id = piece.slice(1);
    else if (pair && attributes.has(pair[1]!)) return `"${pair[1]}" stands twice in the braces`;
    else if (pair) attributes.set(pair[1]!, pair[2] ?? pair[3] ?? "");
    else return `"${piece}" is neither #id nor name=value`;
  }
  return { name: name!, args: args!, id, attributes };
}
