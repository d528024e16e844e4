import type { Words } from "../src/words/words.ts";

/** A part of the course: its lessons by id, which is the folder's name and the place in every address. */
export interface Part {
  readonly title: Words;
  readonly lessons: readonly string[];
}

/** The order of the course. Only lessons whose folder exists are shown; reordering breaks no address. */
export const parts: readonly Part[] = [
  {
    title: { de: "Von Werten zu Kurven", en: "From values to curves" },
    lessons: ["interpolation", "representations", "parameter", "basis-functions"],
  },
  {
    title: { de: "Ein Polynom durch alle Punkte", en: "One polynomial through all points" },
    lessons: ["lagrange", "runge"],
  },
  {
    title: { de: "Kontrollpunkte und Tangenten", en: "Control points and tangents" },
    lessons: ["bezier", "hermite"],
  },
  {
    title: { de: "Stück an Stück", en: "Piece by piece" },
    lessons: ["continuity", "splines", "cubic-splines", "parabolic-blending"],
  },
  {
    title: { de: "Eine Formel für alle", en: "One formula for all" },
    lessons: ["matrix-form", "b-splines"],
  },
  { title: { de: "Flächen", en: "Surfaces" }, lessons: ["surfaces"] },
];

/** The live figure of the front page, in the notation of state links, and the lesson that explains it. */
export const hero = {
  demo: "de-casteljau",
  query: "points=2.2,0.8;0.2,-0.1;-0.3,2.1;1.5,2.95;3.7,2.9;4.8,1.3;4,-0.05&t=0.55",
  lesson: "bezier",
};
