/** How many entries the index palette has; a higher index starts again from the first. */
export const INDEX_COUNT = 10;

type IndexToken = `index-${0 | 1 | 2 | 3 | 4 | 5 | 6 | 7 | 8 | 9}`;

/** The names of the colours: the same in every theme, in the page's style sheet and in exports. */
export type Token =
  | "paper"
  | "raised"
  | "rule"
  | "grid"
  | "ink"
  | "soft"
  | "lath"
  | "curve"
  | "rest"
  | "polygon"
  | "good"
  | "bad"
  // Surfaces: the darkest and the lightest tone of the side their normals point to, and of the other side.
  | "front-dim"
  | "front-lit"
  | "back-dim"
  | "back-lit"
  | "shadow"
  | "mesh"
  | IndexToken;

/** A colour for every token. */
export type Palette = Readonly<Record<Token, string>>;

export type Theme = "light" | "dark" | "print" | "forced";

/** The token of an entry of the index palette. */
export function indexToken(index: number): IndexToken {
  const entry = ((Math.trunc(index) % INDEX_COUNT) + INDEX_COUNT) % INDEX_COUNT;
  return `index-${entry}` as IndexToken;
}

// The first four are the design's; the others were searched for: as far apart as possible, from the first
// four and from the curve as well, for normal, red-blind, green-blind and blue-blind eyes at once, readable
// as text (≥ 4.5 : 1), and of the same hue in light and dark.
const INDEX_LIGHT = [
  "#0a5ea8",
  "#b8420a",
  "#0b7050",
  "#8f3a86",
  "#3f4b04",
  "#d5225b",
  "#4c0faa",
  "#5a210b",
  "#7b55e7",
  "#643b56",
];
const INDEX_DARK = [
  "#6db3f2",
  "#ff9a62",
  "#4fc79c",
  "#dd92d6",
  "#f0d947",
  "#ea696e",
  "#9884f3",
  "#c8800d",
  "#c9c2fc",
  "#ac849e",
];

function withIndex(named: Omit<Palette, IndexToken>, index: readonly string[]): Palette {
  const entries = index.map((colour, i) => [`index-${i}`, colour]);
  return { ...named, ...(Object.fromEntries(entries) as Record<IndexToken, string>) };
}

/**
 * The colours of each theme. `forced` names system colours as style sheets take them; the grid is thinned out,
 * for the grey of a forced palette may be a shrill one.
 */
export const palettes: Readonly<Record<Theme, Palette>> = {
  light: withIndex(
    {
      paper: "#fbfaf6",
      raised: "#f4f1e9",
      rule: "#ddd8cb",
      grid: "#ebe7dc",
      ink: "#1b2230",
      soft: "#565e6c",
      lath: "#b4570a",
      curve: "#17365c",
      rest: "#8391a5",
      polygon: "#737a87",
      good: "#0b7050",
      bad: "#b3261e",
      "front-dim": "#8ba2c4",
      "front-lit": "#f3f7fc",
      "back-dim": "#c19c72",
      "back-lit": "#f8eedd",
      shadow: "#1b2230",
      mesh: "#7d93b5",
    },
    INDEX_LIGHT,
  ),
  dark: withIndex(
    {
      paper: "#14181f",
      raised: "#1b212a",
      rule: "#323a46",
      grid: "#20262f",
      ink: "#e9e6de",
      soft: "#a3abb8",
      lath: "#f0a04b",
      curve: "#dfe8f5",
      rest: "#6d7889",
      polygon: "#8690a0",
      good: "#4fc79c",
      bad: "#ff8a80",
      "front-dim": "#1c2f4a",
      "front-lit": "#5d80ab",
      "back-dim": "#3a2a17",
      "back-lit": "#94703f",
      shadow: "#000000",
      mesh: "#8aa6cc",
    },
    INDEX_DARK,
  ),
  print: withIndex(
    {
      paper: "#ffffff",
      raised: "#f5f5f5",
      rule: "#bbbbbb",
      grid: "#dddddd",
      ink: "#000000",
      soft: "#444444",
      lath: "#9a4606",
      curve: "#000000",
      rest: "#888888",
      polygon: "#666666",
      good: "#0b7050",
      bad: "#b3261e",
      "front-dim": "#8796ad",
      "front-lit": "#f7f9fc",
      "back-dim": "#b3a58f",
      "back-lit": "#faf6ee",
      shadow: "#000000",
      mesh: "#66758c",
    },
    INDEX_LIGHT,
  ),
  forced: withIndex(
    {
      paper: "Canvas",
      raised: "Canvas",
      rule: "CanvasText",
      grid: "color-mix(in srgb, GrayText 35%, Canvas)",
      ink: "CanvasText",
      soft: "CanvasText",
      lath: "Highlight",
      curve: "CanvasText",
      rest: "GrayText",
      polygon: "CanvasText",
      good: "CanvasText",
      bad: "CanvasText",
      "front-dim": "GrayText",
      "front-lit": "Canvas",
      "back-dim": "GrayText",
      "back-lit": "Canvas",
      shadow: "GrayText",
      mesh: "GrayText",
    },
    Array.from({ length: INDEX_COUNT }, () => "CanvasText"),
  ),
};

/** The palette of forced colours, each read out by the browser: for canvases, which take no changing colours. */
export function forcedPalette(read: (systemColour: string) => string): Palette {
  const entries = Object.entries(palettes.forced).map(([token, keyword]) => [token, read(keyword)]);
  return Object.fromEntries(entries) as Palette;
}
