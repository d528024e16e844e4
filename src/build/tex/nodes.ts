/** TeX, as far as symbols must be found in it: signs, commands, groups. Writing the nodes gives the source back. */
export type TexNode =
  | { readonly kind: "sign"; readonly text: string }
  | { readonly kind: "command"; readonly text: string }
  | { readonly kind: "space"; readonly text: string }
  | { readonly kind: "group"; readonly nodes: readonly TexNode[] };

/** Takes TeX apart. A brace that has no partner stays a sign: KaTeX will name it. */
export function readTex(source: string): TexNode[] {
  const pieces = source.match(/\\[a-zA-Z]+|\\[\s\S]|\s+|[\s\S]/g) ?? [];
  const stack: TexNode[][] = [[]];
  for (const piece of pieces) {
    const top = stack.at(-1)!;
    if (piece === "{") stack.push([]);
    else if (piece === "}" && stack.length > 1) {
      stack.pop();
      stack.at(-1)!.push({ kind: "group", nodes: top });
    } else if (/^\s/.test(piece)) top.push({ kind: "space", text: piece });
    else top.push({ kind: piece.length > 1 ? "command" : "sign", text: piece });
  }
  while (stack.length > 1) {
    const open = stack.pop()!;
    stack.at(-1)!.push({ kind: "sign", text: "{" }, ...open);
  }
  return stack[0]!;
}

/** The source of nodes. */
export function writeTex(nodes: readonly TexNode[]): string {
  return nodes.map((node) => (node.kind === "group" ? `{${writeTex(node.nodes)}}` : node.text)).join("");
}

/** The signs and commands of nodes without braces and space: what two ways of writing the same have in common. */
export function leavesOf(nodes: readonly TexNode[]): string[] {
  return nodes.flatMap((node) =>
    node.kind === "group" ? leavesOf(node.nodes) : node.kind === "space" ? [] : [node.text],
  );
}
