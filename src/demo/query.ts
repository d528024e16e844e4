import type { Demo } from "./define.ts";
import type { State } from "./param.ts";
import { type Checked, readValues } from "./state.ts";

/** Names of a query that speak to the figure's frame, not to its parameters. */
const FRAME = new Set(
  "demo lang theme controls autoplay still dpr camera state seed solutions tries".split(" "),
);

/** No query is longer than this in earnest. */
const MAX_ENTRIES = 64;

/**
 * The notation of a state in a URL: only values that differ from `base`; `;`, `,` and `/` stay readable.
 */
export function writeQuery(demo: Demo, state: State, base: State): string {
  return Object.entries(demo.params)
    .map(([id, param]) => [id, param.write(state[id]), param.write(base[id])] as const)
    .filter(([, text, usual]) => text !== usual)
    .map(
      ([id, text]) =>
        `${id}=${encodeURIComponent(text).replace(/%3B/g, ";").replace(/%2C/g, ",").replace(/%2F/g, "/")}`,
    )
    .join("&");
}

/** Reads the parameters of a query; never throws, whatever the text is. Frame options are passed over. */
export function readQuery(demo: Demo, query: string): Checked {
  return readValues(
    demo,
    splitQuery(query).filter(([id]) => !FRAME.has(id) || Object.hasOwn(demo.params, id)),
  );
}

/** The entries of a query; an escape that is none is left as it stands. */
export function splitQuery(query: string): (readonly [string, string])[] {
  return query
    .replace(/^[?#]/, "")
    .split("&", MAX_ENTRIES)
    .filter((entry) => entry !== "")
    .map((entry) => {
      const cut = entry.indexOf("=");
      return cut < 0
        ? [unescaped(entry), ""]
        : [unescaped(entry.slice(0, cut)), unescaped(entry.slice(cut + 1))];
    });
}

function unescaped(text: string): string {
  try {
    return decodeURIComponent(text.replace(/\+/g, " "));
  } catch {
    return text;
  }
}
