import { same, type Words } from "../../words/words.ts";
import { bad, good, type Param } from "../param.ts";

/** One of a list of options, by id. */
export function choice<const Id extends string>(options: {
  readonly initial: NoInfer<Id>;
  readonly label: Words;
  readonly options: readonly { readonly id: Id; readonly label: Words }[];
}): Param<Id> {
  const ids = options.options.map((option) => option.id);
  const list = ids.join(", ");
  const find = (value: unknown) => {
    const id = ids.find((one) => one === value);
    return id === undefined
      ? bad<Id>(`erwartet wird eines von ${list}`, `expected one of ${list}`)
      : good(id);
  };
  return {
    type: "choice",
    label: options.label,
    initial: options.initial,
    read: find,
    write: (value) => value,
    accept: find,
    round: (value) => value,
    between: (a, b, share) => (share < 1 ? a : b),
    handles: () => [],
    fields: (id, value) => [
      {
        kind: "choice",
        id,
        label: { base: options.label, style: "text" },
        value,
        options: options.options,
        put: (next) => ids.find((one) => one === next) ?? value,
      },
    ],
    actions: () => [],
    notation: () => same(ids.join(" | ")),
  };
}
