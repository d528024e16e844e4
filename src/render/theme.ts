// The face of the theme: colours, looks of roles, and both as style sheets.

export { indexCss } from "./index-css.ts";
export { type Paint, paintOf } from "./paint.ts";
export {
  forcedPalette,
  INDEX_COUNT,
  indexToken,
  type Palette,
  palettes,
  type Theme,
  type Token,
} from "./palette.ts";
export { PARTS, type Part, ROLES, type RoleStyle } from "./roles.ts";
export { figureCss, themeCss } from "./theme-css.ts";
