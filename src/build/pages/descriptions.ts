import type { Words } from "../../words/words.ts";

/** The course in one sentence, for search engines and links. */
export const DESCRIPTION: Words = {
  de: "Ein Kurs über Kurven und Flächen für die Computergrafik, mit Bildern zum Anfassen.",
  en: "A course on curves and surfaces for computer graphics, with pictures that you can move.",
};
