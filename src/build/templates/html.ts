import type { Html, Text } from "./types.ts";

const ENTITIES: Readonly<Record<string, string>> = {
  "&": "&amp;",
  "<": "&lt;",
  ">": "&gt;",
  '"': "&quot;",
};

/** Text as it may stand in markup, between tags as well as in a quoted attribute. */
export function escapeHtml(text: Text): Html {
  return text.replace(/[&<>"]/g, (sign) => ENTITIES[sign]!);
}

/** A start tag's attributes, each with its leading space; those that are null or false are left out. */
export function attributes(values: Readonly<Record<string, string | boolean | null | undefined>>): Html {
  return Object.entries(values)
    .filter(([, value]) => value !== null && value !== undefined && value !== false)
    .map(([name, value]) => (value === true ? ` ${name}` : ` ${name}="${escapeHtml(String(value))}"`))
    .join("");
}

/** The pieces that are there, one a line. */
export function lines(...pieces: readonly (Html | null | false)[]): Html {
  return pieces.filter((piece) => piece !== null && piece !== false && piece !== "").join("\n");
}
