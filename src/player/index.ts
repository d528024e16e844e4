import { CurveDemo, type Registry } from "./curve-demo.ts";

export type { CurveDemo, GoOptions, Registry } from "./curve-demo.ts";

/**
 * Defines `<curve-demo>` for a page, with the demos it knows. With `embedded`, the page is one figure in
 * somebody's frame: the query counts like attributes, and messages are answered.
 */
export function defineCurveDemo(registry: Registry, options: { readonly embedded?: boolean } = {}): void {
  CurveDemo.registry = registry;
  CurveDemo.embedded = options.embedded === true;
  if (!customElements.get("curve-demo")) customElements.define("curve-demo", CurveDemo);
}
