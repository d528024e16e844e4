import { INDEX_COUNT, type Palette, palettes } from "./palette.ts";
import { PARTS, type PartStyle, ROLES } from "./roles.ts";
import { FONTS, SIZE, TEXT_SIZES } from "./sizes.ts";
import { facetsCss } from "./svg-facets.ts";

function properties(palette: Palette): string {
  return Object.entries(palette)
    .map(([token, colour]) => `--${token}:${colour}`)
    .join(";");
}

/**
 * The colours as custom properties of `selector`: light; dark where `data-theme="dark"`, or where the system
 * is dark and `data-theme` is absent or `auto`; print; forced colours. With `:host` for a shadow root.
 */
export function themeCss(selector = ":root"): string {
  const with_ = (condition: string) =>
    selector === ":host" ? `:host(${condition})` : `${selector}${condition}`;
  const dark = properties(palettes.dark);
  return [
    `${selector}{color-scheme:light;${properties(palettes.light)}}`,
    `${with_('[data-theme="dark"]')}{color-scheme:dark;${dark}}`,
    `@media (prefers-color-scheme:dark){${with_(':not([data-theme="light"])')}{color-scheme:dark;${dark}}}`,
    `@media print{${[selector, with_("[data-theme]")].join()}{color-scheme:light;${properties(palettes.print)}}}`,
    `@media (forced-colors:active){${[selector, with_("[data-theme]")].join()}{${properties(palettes.forced)}}}`,
  ].join("\n");
}

/** The rules for SVGs that stand in a page: `scope` selects the svg elements, for instance `figure > svg`. */
export function figureCss(scope: string): string {
  const rule = (selector: string, body: string) => `${scope} ${selector}{${body}}`;
  const rules = Object.entries(ROLES).map(([role, { token, text, width, dash, fill }]) => {
    const lettering = text ? `;--t:${text === "paper" ? "var(--paper)" : `var(--i,var(--${text}))`}` : "";
    return rule(
      `.r-${role}`,
      `--c:var(--${token});--w:${width};--f:${fill}${lettering}${dash ? `;--d:${dash.join(" ")};--e:butt` : ""}`,
    );
  });
  for (let i = 0; i < INDEX_COUNT; i++) rules.push(rule(`.i${i}`, `--i:var(--index-${i})`));
  for (const [part, style] of Object.entries(PARTS)) rules.push(rule(`.p-${part}`, partRule(style)));
  rules.push(rule(".p-text", "paint-order:stroke"));
  for (const [font, family] of Object.entries(FONTS)) {
    rules.push(rule(`.f-${font}`, `font:${font === "math" ? "italic " : ""}${SIZE.label}px ${family}`));
  }
  for (const size of TEXT_SIZES) rules.push(rule(`.s${size}`, `font-size:${size}px`));
  rules.push(facetsCss(scope));
  return rules.join("\n");
}

const COLOUR = { own: "var(--i,var(--c))", text: "var(--t,var(--i,var(--c)))", paper: "var(--paper)" };

function partRule(style: PartStyle): string {
  const body = [`fill:${style.fill ? COLOUR[style.fill] : "none"}`];
  if (style.fillOpacity !== undefined)
    body.push(`fill-opacity:${style.fillOpacity === "role" ? "var(--f)" : style.fillOpacity}`);
  if (style.stroke) {
    body.push(`stroke:${COLOUR[style.stroke]}`);
    body.push(`stroke-width:${style.width === "role" ? "var(--w)" : style.width}`, "stroke-linejoin:round");
    body.push(`stroke-linecap:${style.dash ? "var(--e,round)" : "round"}`);
    if (style.dash) body.push("stroke-dasharray:var(--d,none)");
    if (style.opacity !== undefined) body.push(`stroke-opacity:${style.opacity}`);
  }
  return body.join(";");
}
