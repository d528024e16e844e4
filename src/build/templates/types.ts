import type { Lang } from "../../words/words.ts";

/** Text for people, not yet escaped: the templates escape it. */
export type Text = string;
/** Ready markup, made by the build from markdown, TeX or a scene. */
export type Html = string;
/** A path below the site's root without a leading slash ("de/bezier/"); the shell puts `root` before it. */
export type Path = string;

export interface Link {
  readonly href: Path;
  readonly title: Text;
}

/** A heading of the page that the navigation lists; the id is an anchor of the page. */
export interface NavSection {
  readonly id: string;
  readonly title: Html;
}

export interface NavLesson extends Link {
  readonly id: string;
  readonly current: boolean;
  /** The sections, for the current lesson; empty else. */
  readonly sections: readonly NavSection[];
}

export interface NavPart {
  readonly title: Text;
  readonly lessons: readonly NavLesson[];
}

/** What stands around the content of a site page. */
export interface Chrome {
  /** The course: parts and lessons that exist, in order. */
  readonly parts: readonly NavPart[];
  /** Further links of the header, beyond the course itself (gallery, teachers), if those pages exist. */
  readonly links: readonly Link[];
  /** The same page in the other language. */
  readonly alternate: Path;
}

/** A whole HTML document. */
export interface ShellPage {
  readonly lang: Lang;
  /** The page's own title; the shell adds the site's name, if it differs. */
  readonly title: Text;
  readonly description: Text;
  /** From the page back to the site's root: "", "../" or "../../"; "./" never. */
  readonly root: string;
  /** Style sheets and module scripts, as paths below the root. */
  readonly styles: readonly Path[];
  readonly scripts: readonly Path[];
  /** Fonts to be asked for before the style sheets are read. */
  readonly fonts: readonly Path[];
  /** The inline line that sets the theme before the first paint: `BOOT` of boot.ts. */
  readonly bootScript: string;
  /** The content security policy; null in the dev server. */
  readonly csp: string | null;
  /** Header, navigation, footer; null for pages without (embed, chooser). */
  readonly chrome: Chrome | null;
  /** What `main` holds; with `chrome: null`, what `body` holds. */
  readonly body: Html;
  /** `lesson-page`, `front-page`, `embed-page`, `chooser-page`; layout and scripts go by it. */
  readonly bodyClass: string;
  readonly noindex?: boolean;
  /** Absolute addresses, only when SITE_URL is set. */
  readonly canonical?: string;
  readonly alternates?: readonly { readonly lang: Lang | "x-default"; readonly href: string }[];
}

/** A demo in a page. */
export interface FigureData {
  /** The figure's id: anchor and name for state links. */
  readonly id: string;
  readonly demo: string;
  readonly lang: Lang;
  /** Attributes of `<curve-demo>` beside `demo`: parameters, `controls`, `still`, … */
  readonly attributes: Readonly<Record<string, string>>;
  /** `figureBox(demo)`. */
  readonly box: {
    readonly wide: number;
    readonly narrow: number;
    readonly belowWide: number;
    readonly belowNarrow: number;
  };
  /** The static picture. */
  readonly svg: Html;
  /** Block markup; empty for a figure without a caption. */
  readonly caption: Html;
  /** The caption on paper, if it differs. */
  readonly printCaption: Html;
}

/** The body of a lesson. */
export interface LessonPage {
  readonly lang: Lang;
  readonly id: string;
  /** Its place among all lessons of the course, from 1. */
  readonly number: number;
  readonly minutes: number;
  readonly title: Text;
  readonly lead: Html;
  readonly goals: readonly Html[];
  /** The lessons to have read, as links where they exist. */
  readonly prerequisites: readonly Link[];
  /** Whether the lesson goes beyond the scripts. */
  readonly addition: boolean;
  /** The lesson as rendered from markdown, sections and all. */
  readonly body: Html;
  readonly root: string;
  readonly previous: Link | null;
  readonly next: Link | null;
}

/** A lesson on the course map. */
export interface MapLesson extends Link {
  readonly id: string;
  readonly number: number;
  readonly lead: Html;
  readonly minutes: number;
  /** Ids of the lessons it builds on; those that do not exist yet are passed over. */
  readonly prerequisites: readonly string[];
  readonly addition: boolean;
}

export interface MapPart {
  readonly title: Text;
  readonly lessons: readonly MapLesson[];
}

/** The body of a front page. */
export interface FrontPage {
  readonly lang: Lang;
  readonly root: string;
  /** The live figure at the top, and where it is explained. Its caption is the template's. */
  readonly hero: FigureData;
  readonly heroLesson: Link | null;
  readonly parts: readonly MapPart[];
}

/** The body of an embed page: one demo, nothing else. */
export interface EmbedPage {
  readonly title: Readonly<Record<Lang, Text>>;
  readonly figure: FigureData;
}

/** 404.html: a whole document, not made from the shell. */
export interface NotFoundPage {
  /** The whole style sheet: `themeCss()` and `NOT_FOUND_CSS` of not-found-page.ts. */
  readonly css: string;
  /** The policy that allows `BOOT` and `css` by their hashes; null in the dev server. */
  readonly csp: string | null;
  /** The site's address with a slash at its end, if it is known. */
  readonly home: string | null;
}

// ——— Pieces of a lesson: the markdown rules call the template of the same name. ———

/** `section.ts`: an h2 with all that follows; long sections are not laid out until they come near. */
export interface SectionData {
  readonly html: Html;
  readonly formulas: number;
  readonly figures: number;
  /** Characters of its text, roughly. */
  readonly characters: number;
}

export const BLOCK_KINDS = [
  "note",
  "definition",
  "theorem",
  "proof",
  "example",
  "history",
  "correction",
  "addition",
] as const;
export type BlockKind = (typeof BLOCK_KINDS)[number];

/** `block.ts` */
export interface BlockData {
  readonly lang: Lang;
  readonly kind: BlockKind;
  /** The words after the kind's name: "Definition (Bézierkurve)"; empty for none. */
  readonly title: Html;
  readonly id: string | null;
  readonly html: Html;
}

/** How a guess is made: by choosing, by a number, by a mark placed in the figure. */
export type Guess =
  | { readonly kind: "choice"; readonly options: readonly { readonly html: Html; readonly right: boolean }[] }
  | { readonly kind: "number"; readonly value: number; readonly within: number }
  | { readonly kind: "place"; readonly name: string; readonly within: number };

/** `predict.ts`: the question first, a guess, then the answer. */
export interface PredictData {
  readonly lang: Lang;
  /** Unique in the page. */
  readonly id: string;
  readonly question: Html;
  readonly guess: Guess;
  /** The figure that answers, and the state in which it does; null if the text answers alone. */
  readonly figure: { readonly id: string; readonly query: string } | null;
  readonly answer: Html;
}

/** `formula.ts`: a displayed formula in a box that scrolls when it is wider than the column. */
export interface FormulaData {
  readonly lang: Lang;
  readonly id: string | null;
  readonly html: Html;
  /** The formula in words, for the label of the scrolling box; empty for a general one. */
  readonly words: Text;
  /** Its symbols, each once: the list behind the button after the formula. */
  readonly symbols: readonly {
    /** As it is spoken. */
    readonly say: Text;
    /** `figure/name`; null for a symbol that no picture shows. */
    readonly tie: string | null;
    /** Number of its entry in the lesson's glossary; null if it has none. */
    readonly entry: number | null;
    /** `figure/path` of its value, where that is not found under its name. */
    readonly value: string | null;
    /** The symbol as the list shows it, where it does not stand in the formula. */
    readonly glyph: Html | null;
  }[];
}

/** `symbols.ts`: the glossary of a lesson. */
export interface SymbolsData {
  readonly lang: Lang;
  readonly id: string | null;
  readonly entries: readonly { readonly number: number; readonly symbol: Html; readonly meaning: Html }[];
}

/** `state-link.ts`: words that put a figure into a state. */
export interface StateLinkData {
  readonly lang: Lang;
  readonly figure: string;
  /** The query without question mark: "t=0.5"; empty for the figure's own initial state. */
  readonly query: string;
  readonly html: Html;
}

/** `table.ts`: html is the whole `<table>…</table>`. */
export interface TableData {
  readonly lang: Lang;
  readonly html: Html;
}

/** `code.ts`: lines of `src/math`, highlighted or plain, with where they are taken from. */
export interface CodeData {
  readonly lang: Lang;
  readonly html: Html;
  readonly source: Text;
}
