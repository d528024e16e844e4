/** A font of the pages, as its package brings it. */
export interface Face {
  readonly family: string;
  readonly style: "normal" | "italic";
  readonly weight: string;
  /** Path below `node_modules/`. */
  readonly file: string;
  /** The characters for which the file is asked; empty for all. */
  readonly range: string;
  /** Text may do without a font that comes late; a formula may not. */
  readonly display: "optional" | "block";
  /** Variable fonts are cut down to these weights. */
  readonly weights?: readonly [number, number];
  /** Whether an embed needs it: lettering of the figure and the interface. */
  readonly embed: boolean;
  /** The first lines of every page are set in it. */
  readonly first: boolean;
}

/** The weights that the style sheets use. */
const WEIGHTS = [400, 600] as const;

const LATIN =
  "U+0-FF,U+131,U+152-153,U+2BB-2BC,U+2C6,U+2DA,U+2DC,U+304,U+308,U+329,U+2000-206F,U+20AC,U+2122,U+2191,U+2193,U+2212,U+2215,U+FEFF,U+FFFD";
const GREEK = "U+370-377,U+37A-37F,U+384-38A,U+38C,U+38E-3A1,U+3A3-3FF";
const LATIN_EXT =
  "U+100-130,U+132-151,U+154-2BA,U+2BD-2C5,U+2C7-2CC,U+2CE-2D7,U+2DD-2FF,U+1D00-1DBF,U+1E00-1E9F,U+1EF2-1EFF,U+2113,U+2C60-2C7F";

function textFaces(family: string, name: string, style: Face["style"], embed: boolean): Face[] {
  return [
    ["latin", LATIN],
    ["latin-ext", LATIN_EXT],
    ["greek", GREEK],
  ].map(([part, range]) => ({
    family,
    style,
    weight: WEIGHTS.join(" "),
    file: `@fontsource-variable/${name}/files/${name}-${part}-wght-${style}.woff2`,
    range: range!,
    display: "optional",
    weights: WEIGHTS,
    embed,
    first: part === "latin" && style === "normal",
  }));
}

function formulaFace(name: string, weight: string, style: Face["style"], embed = false): Face {
  const family = `KaTeX_${name.split("-")[0]}`;
  const file = `katex/dist/fonts/KaTeX_${name}.woff2`;
  // The two that figures are lettered with are those of nearly every formula: coming late, they would move words.
  return { family, style, weight, file, range: "", display: "block", embed, first: embed };
}

/** Every font that a page may ask for. KaTeX's are those of its style sheet. */
export const FACES: readonly Face[] = [
  ...textFaces("Source Serif 4", "source-serif-4", "normal", false),
  ...textFaces("Source Serif 4", "source-serif-4", "italic", false),
  ...textFaces("Source Sans 3", "source-sans-3", "normal", true),
  ...textFaces("Source Sans 3", "source-sans-3", "italic", false),
  formulaFace("AMS-Regular", "400", "normal"),
  formulaFace("Caligraphic-Bold", "700", "normal"),
  formulaFace("Caligraphic-Regular", "400", "normal"),
  formulaFace("Fraktur-Bold", "700", "normal"),
  formulaFace("Fraktur-Regular", "400", "normal"),
  formulaFace("Main-Bold", "700", "normal"),
  formulaFace("Main-BoldItalic", "700", "italic"),
  formulaFace("Main-Italic", "400", "italic"),
  formulaFace("Main-Regular", "400", "normal", true),
  formulaFace("Math-BoldItalic", "700", "italic"),
  formulaFace("Math-Italic", "400", "italic", true),
  formulaFace("SansSerif-Bold", "700", "normal"),
  formulaFace("SansSerif-Italic", "400", "italic"),
  formulaFace("SansSerif-Regular", "400", "normal"),
  formulaFace("Script-Regular", "400", "normal"),
  formulaFace("Size1-Regular", "400", "normal"),
  formulaFace("Size2-Regular", "400", "normal"),
  formulaFace("Size3-Regular", "400", "normal"),
  formulaFace("Size4-Regular", "400", "normal"),
  formulaFace("Typewriter-Regular", "400", "normal"),
];

/** The rule that names a font to the browser. */
export function faceRule(face: Face, url: string): string {
  const range = face.range ? `unicode-range:${face.range};` : "";
  return (
    `@font-face{font-family:"${face.family}";font-style:${face.style};font-weight:${face.weight};` +
    `font-display:${face.display};${range}src:url(${url}) format("woff2")}`
  );
}
