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
  | "good"
  | "bad"
  | IndexToken;

/** A colour for every token. */
export type Palette = Readonly<Record<Token, string>>;

export type Theme = "light" | "dark" | "print" | "forced";

/** The token of an entry of the index palette. */
export function indexToken(index: number): IndexToken {
  const entry = ((Math.trunc(index) % INDEX_COUNT) + INDEX_COUNT) % INDEX_COUNT;
  return `index-${entry}` as IndexToken;
}

// Chosen together: each entry is readable as text on its paper (≥ 4.5 : 1), and all of them differ for
// normal, red-blind, green-blind and blue-blind eyes. Neighbours in the sequence differ most.
const INDEX_LIGHT = [
  "#0a5ea8",
  "#b8420a",
  "#0b7050",
  "#8f3a86",
  "#6b5a00",
  "#2b2f86",
  "#a01838",
  "#0f6f84",
  "#5a3a1e",
  "#4d6a16",
];
const INDEX_DARK = [
  "#6db3f2",
  "#ff9a62",
  "#4fc79c",
  "#dd92d6",
  "#d8c24a",
  "#a5a8ff",
  "#ff8fa3",
  "#5fd0e6",
  "#cfae8a",
  "#a9cf62",
];

function withIndex(named: Omit<Palette, IndexToken>, index: readonly string[]): Palette {
  const entries = index.map((colour, i) => [`index-${i}`, colour]);
  return { ...named, ...(Object.fromEntries(entries) as Record<IndexToken, string>) };
}

/** The colours of each theme. `forced` names system colours, as style sheets and canvases take them. */
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
      good: "#0b7050",
      bad: "#b3261e",
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
      good: "#4fc79c",
      bad: "#ff8a80",
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
      good: "#0b7050",
      bad: "#b3261e",
    },
    INDEX_LIGHT,
  ),
  forced: withIndex(
    {
      paper: "Canvas",
      raised: "Canvas",
      rule: "CanvasText",
      grid: "GrayText",
      ink: "CanvasText",
      soft: "CanvasText",
      lath: "Highlight",
      curve: "CanvasText",
      rest: "GrayText",
      good: "CanvasText",
      bad: "CanvasText",
    },
    Array.from({ length: INDEX_COUNT }, () => "CanvasText"),
  ),
};

/** The palette of forced colours with every system colour read out, where its keyword cannot be used. */
export function forcedPalette(read: (systemColour: string) => string): Palette {
  const entries = Object.entries(palettes.forced).map(([token, keyword]) => [token, read(keyword)]);
  return Object.fromEntries(entries) as Palette;
}
