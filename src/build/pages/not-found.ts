import { themeCss } from "../../render/theme.ts";
import { contentSecurityPolicy } from "../csp.ts";
import { BOOT } from "../templates/boot.ts";
import { NOT_FOUND_CSS, notFoundPage } from "../templates/not-found-page.ts";
import type { PageOptions } from "./page.ts";

/** The page for addresses that lead nowhere, complete in itself since it is shown at any depth. */
export function notFound({ policy, siteUrl }: Pick<PageOptions, "policy" | "siteUrl">): string {
  const css = themeCss() + NOT_FOUND_CSS;
  const csp = policy ? contentSecurityPolicy({ scripts: [BOOT], styles: [css] }) : null;
  return notFoundPage({ css, csp, home: siteUrl });
}
