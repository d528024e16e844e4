import type { Lang } from "../../words/words.ts";
import type { BlockKind } from "./types.ts";

export const SITE_NAME = "Straklatte";

/** What the templates themselves say, page by page the same. */
export interface PageWords {
  readonly skip: string;
  readonly home: string;
  readonly course: string;
  readonly contents: string;
  readonly closeContents: string;
  readonly mainNavigation: string;
  readonly onThisPage: string;
  readonly otherLanguage: string;
  readonly otherLanguageShort: string;
  readonly themeAuto: string;
  readonly themeLight: string;
  readonly themeDark: string;
  readonly lesson: (number: number, minutes: number) => string;
  readonly goals: string;
  readonly prerequisites: string;
  readonly addition: string;
  readonly previous: string;
  readonly next: string;
  readonly neighbours: string;
  readonly footer: string;
  readonly textLicence: string;
  readonly codeLicence: string;
  readonly formula: string;
  readonly code: string;
  readonly table: string;
  readonly inTheFigure: string;
  readonly guess: string;
  readonly answer: string;
  readonly rightAnswer: string;
  readonly wrongAnswer: string;
  readonly commit: string;
  readonly guessNumber: string;
  readonly guessPlace: string;
  readonly symbols: string;
  readonly symbolsOfFormula: string;
  readonly symbolsOfLesson: string;
  readonly codeFrom: (source: string) => string;
  readonly blocks: Readonly<Record<BlockKind | "predict", string>>;
}

export const WORDS: Readonly<Record<Lang, PageWords>> = {
  de: {
    skip: "Zum Inhalt springen",
    home: "Straklatte, zur Startseite",
    course: "Kurs",
    contents: "Inhalt",
    closeContents: "Inhalt schließen",
    mainNavigation: "Kurs",
    onThisPage: "Auf dieser Seite",
    otherLanguage: "English",
    otherLanguageShort: "EN",
    themeAuto: "Farben: wie das System",
    themeLight: "Farben: hell",
    themeDark: "Farben: dunkel",
    lesson: (number, minutes) => `Lektion ${number} · etwa ${minutes} Minuten`,
    goals: "Danach können Sie",
    prerequisites: "Vorher lesen",
    addition: "Geht über die Vorlesung hinaus",
    previous: "Zurück",
    next: "Weiter",
    neighbours: "Benachbarte Lektionen",
    footer: "Straklatte, ein Kurs über Kurven und Flächen",
    textLicence: "Text und Bilder: CC BY 4.0",
    codeLicence: "Programm: MIT-Lizenz",
    formula: "Formel",
    code: "Programmzeilen",
    table: "Tabelle",
    inTheFigure: "in der Figur",
    guess: "Ihre Vermutung",
    answer: "Auflösen",
    rightAnswer: "richtig",
    wrongAnswer: "trifft nicht zu",
    commit: "Vermutung festlegen",
    guessNumber: "Ihre Zahl",
    guessPlace:
      "Schieben Sie den Punkt „Ihr Tipp“ in der Figur an die Stelle, mit der Maus, dem Finger oder den Pfeiltasten.",
    symbols: "Zeichen",
    symbolsOfFormula: "Zeichen dieser Formel",
    symbolsOfLesson: "Zeichen dieser Lektion",
    codeFrom: (source) => `Die Zeilen stehen so in ${source}.`,
    blocks: {
      note: "Anmerkung",
      definition: "Definition",
      theorem: "Satz",
      proof: "Beweis",
      example: "Beispiel",
      history: "Zur Geschichte",
      correction: "Berichtigung",
      addition: "Ergänzung",
      predict: "Vorhersage",
    },
  },
  en: {
    skip: "Skip to the content",
    home: "Straklatte, to the front page",
    course: "Course",
    contents: "Contents",
    closeContents: "Close the contents",
    mainNavigation: "Course",
    onThisPage: "On this page",
    otherLanguage: "Deutsch",
    otherLanguageShort: "DE",
    themeAuto: "Colours: as the system",
    themeLight: "Colours: light",
    themeDark: "Colours: dark",
    lesson: (number, minutes) => `Lesson ${number} · about ${minutes} minutes`,
    goals: "Afterwards you can",
    prerequisites: "Read first",
    addition: "Goes beyond the lecture",
    previous: "Back",
    next: "Next",
    neighbours: "Neighbouring lessons",
    footer: "Straklatte, a course on curves and surfaces",
    textLicence: "Text and pictures: CC BY 4.0",
    codeLicence: "Program: MIT licence",
    formula: "Formula",
    code: "Lines of the program",
    table: "Table",
    inTheFigure: "in the figure",
    guess: "Your guess",
    answer: "Show the answer",
    rightAnswer: "right",
    wrongAnswer: "does not hold",
    commit: "Commit to this guess",
    guessNumber: "Your number",
    guessPlace:
      "Move the point “your guess” in the figure to the place, with the mouse, a finger or the arrow keys.",
    symbols: "Symbols",
    symbolsOfFormula: "Symbols of this formula",
    symbolsOfLesson: "Symbols of this lesson",
    codeFrom: (source) => `These lines stand in ${source}.`,
    blocks: {
      note: "Note",
      definition: "Definition",
      theorem: "Theorem",
      proof: "Proof",
      example: "Example",
      history: "History",
      correction: "Correction",
      addition: "Addition",
      predict: "Predict",
    },
  },
};
