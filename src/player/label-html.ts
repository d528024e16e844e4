import type { Label } from "../scene/label.ts";
import { formatNumber } from "../words/numbers.ts";
import type { Lang } from "../words/words.ts";
import { element } from "./element.ts";

const SUBSCRIPTS: Record<string, string> = Object.fromEntries(
  [..."0123456789"].map((d, i) => [d, "₀₁₂₃₄₅₆₇₈₉"[i]!]),
);

function baseOf(label: Label, lang: Lang): string {
  return typeof label.base === "string" ? label.base : label.base[lang];
}

function argsOf(label: Label, lang: Lang): string {
  if (!label.args) return "";
  const parts = label.args.map((arg) => (typeof arg === "number" ? formatNumber(arg, lang) : arg));
  const commaTaken = lang === "de" && label.args.some((arg) => typeof arg === "number");
  return `(${parts.join(commaTaken ? "; " : ", ")})`;
}

/** A label as plain text: c₂, p′(0,4). For names that are spoken, titles, tooltips. */
export function labelText(label: Label, lang: Lang): string {
  const sub = label.sub
    ? [...label.sub].every((c) => c in SUBSCRIPTS)
      ? [...label.sub].map((c) => SUBSCRIPTS[c]).join("")
      : ` ${label.sub}`
    : "";
  const sup = label.sup ? `^${label.sup}` : "";
  return `${baseOf(label, lang)}${"′".repeat(label.prime ?? 0)}${sub}${sup}${argsOf(label, lang)}`;
}

/** A label as set mathematics, for the rows below the picture. */
export function labelHtml(label: Label, lang: Lang): HTMLElement {
  const math = label.style !== "text";
  const root = element("span", { class: math ? "math" : "" });
  root.append(math ? element("i", {}, baseOf(label, lang)) : baseOf(label, lang));
  if (label.prime) root.append(element("sup", { class: "prime" }, "′".repeat(label.prime)));
  if (label.sub || label.sup) root.append(scripts(label));
  const args = argsOf(label, lang);
  // Letters among the arguments are variables: p(t).
  for (const part of args.split(/([a-z])/i)) {
    if (part !== "") root.append(math && /^[a-z]$/i.test(part) ? element("i", {}, part) : part);
  }
  return root;
}

/** Sub- and superscript stand above each other, as in the formulas: B_i^n. */
function scripts({ sub, sup }: Label): HTMLElement {
  if (!sup) return element("sub", {}, ...letters(sub ?? ""));
  if (!sub) return element("sup", {}, ...letters(sup));
  return element(
    "span",
    { class: "scripts" },
    element("span", {}, ...letters(sup)),
    element("span", {}, ...letters(sub)),
  );
}

/** Letters are variables, digits are not. */
function letters(text: string): (Node | string)[] {
  return text
    .split(/([a-z]+)/i)
    .filter((part) => part !== "")
    .map((part) => (/^[a-z]+$/i.test(part) ? element("i", {}, part) : part));
}
