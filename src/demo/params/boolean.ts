import type { Words } from "../../words/words.ts";
import { bad, good, type Param } from "../param.ts";

/** A switch; `1` and `0` in URLs, and an empty attribute means on. */
export function boolean(options: { readonly initial: boolean; readonly label: Words }): Param<boolean> {
  const refuse = () => bad<boolean>("erwartet wird 1 oder 0", "expected 1 or 0");
  return {
    type: "boolean",
    label: options.label,
    initial: options.initial,
    read: (text) => (text === "1" || text === "" ? good(true) : text === "0" ? good(false) : refuse()),
    write: (value) => (value ? "1" : "0"),
    accept: (value) => (typeof value === "boolean" ? good(value) : refuse()),
    round: (value) => value,
    between: (a, b, share) => (share < 1 ? a : b),
    handles: () => [],
    fields: (id, value) => [
      { kind: "boolean", id, label: { base: options.label, style: "text" }, value, put: (next) => next },
    ],
    actions: () => [],
    notation: () => ({ de: "1 oder 0", en: "1 or 0" }),
  };
}
