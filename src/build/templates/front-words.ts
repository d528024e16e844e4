import type { Lang } from "../../words/words.ts";
import type { Picture } from "./pictures/index.ts";
import type { Html, Text } from "./types.ts";

/** A field in which freeform curves are at work. */
export interface Use {
  readonly picture: Picture;
  /** The lesson that tells more, once it exists. */
  readonly lesson: string;
  readonly title: Text;
  readonly text: Html;
}

export interface FrontWords {
  readonly title: Text;
  readonly lead: Text;
  readonly begin: Text;
  readonly map: Text;
  readonly heroCaption: Html;
  readonly heroLesson: (link: Html) => Html;
  readonly usesTitle: Text;
  readonly uses: readonly Use[];
  readonly moreIn: Text;
  readonly mapTitle: Text;
  readonly mapIntro: Text;
  readonly buildsOn: Text;
  readonly minutes: (minutes: number) => Text;
  readonly addition: Text;
  readonly howTitle: Text;
  readonly how: readonly (readonly [name: Text, text: Text])[];
}

export const FRONT_WORDS: Readonly<Record<Lang, FrontWords>> = {
  de: {
    title: "Kurven und Flächen zum Anfassen",
    lead: "Wie beschreibt man eine Form, für die es weder Lineal noch Zirkel gibt, so dass ein Rechner sie zeichnen und ein Mensch sie führen kann? Dieser Kurs zeigt es an Figuren, die Sie selbst bewegen.",
    begin: "Zur ersten Lektion",
    map: "Zum Kursplan",
    heroCaption:
      "<strong>Wenige Punkte führen die ganze Kurve.</strong> Ziehen Sie an einem davon, oder verschieben Sie <i>t</i>.",
    heroLesson: (link) => `Wie die Konstruktion geht, erklärt die Lektion ${link}.`,
    usesTitle: "Wo solche Kurven arbeiten",
    uses: [
      {
        picture: "ships",
        lesson: "splines",
        title: "Schiffbau",
        text: 'Eine Straklatte ist die dünne Holzlatte, mit der Schiffbauer die Linien eines Rumpfes zogen: von Gewichten gehalten, dazwischen so wenig gebogen wie möglich. Auf Englisch heißt sie <i lang="en">spline</i>. Damit fing es an.',
      },
      {
        picture: "cad",
        lesson: "bezier",
        title: "CAD",
        text: "Um 1960 wurden Karosserien zum ersten Mal gerechnet. Paul de Casteljau bei Citroën und Pierre Bézier bei Renault fanden dafür, jeder für sich, dieselbe Kurve.",
      },
      {
        picture: "design",
        lesson: "continuity",
        title: "Industriedesign",
        text: "Ob eine Fläche stimmt, verrät ihr Spiegelbild. Wo zwei Stücke nur ohne Knick aneinanderstoßen, knickt die Spiegelung; erst bei gleicher Krümmung läuft sie glatt weiter.",
      },
      {
        picture: "film",
        lesson: "surfaces",
        title: "Film",
        text: "Haut, Stoff und Wasser sind auf der Leinwand oft Flächen, die an einem Netz weniger Punkte hängen. Bewegt werden die Punkte, die Fläche folgt.",
      },
      {
        picture: "camera",
        lesson: "splines",
        title: "Kamerafahrten",
        text: "Eine Kamera soll durch ein paar festgelegte Orte fliegen. Den Weg dazwischen rechnet ein Spline, und seine Glattheit entscheidet, ob der Flug ruckt.",
      },
      {
        picture: "animation",
        lesson: "hermite",
        title: "Animation",
        text: "Auch eine Bewegung ist eine Kurve: ein Wert über der Zeit. Ihre Steigung ist die Geschwindigkeit. Wer die Tangenten stellt, bestimmt, wie etwas anläuft und ausrollt.",
      },
    ],
    moreIn: "Mehr dazu:",
    mapTitle: "Der Kurs",
    mapIntro:
      "Jede Lektion zeigt, auf welchen anderen sie aufbaut. Wer schon etwas weiß, steigt dort ein, wo es neu wird.",
    buildsOn: "Baut auf:",
    minutes: (minutes) => `${minutes} Minuten`,
    addition: "Ergänzung",
    howTitle: "Wie man hier liest",
    how: [
      [
        "Bewegen",
        "Was einen Ring um den Punkt trägt, lässt sich verschieben: mit der Maus, mit dem Finger oder mit den Pfeiltasten. Jeder Schritt lässt sich zurücknehmen.",
      ],
      [
        "Nachstellen",
        "Gepunktet unterstrichene Wörter bringen die Figur in den Zustand, von dem der Satz spricht. So lässt sich jede Behauptung sofort prüfen.",
      ],
      ["Vorhersagen", "Erst vermuten, dann auflösen. Wer sich festgelegt hat, sieht genauer hin."],
    ],
  },
  en: {
    title: "Curves and surfaces to take hold of",
    lead: "How do you describe a shape that neither ruler nor compass can draw, so that a computer can render it and a person can steer it? This course answers with figures that you move yourself.",
    begin: "To the first lesson",
    map: "To the course map",
    heroCaption:
      "<strong>A handful of points steers the whole curve.</strong> Drag one of them, or slide <i>t</i>.",
    heroLesson: (link) => `How the construction works is told in the lesson ${link}.`,
    usesTitle: "Where such curves are at work",
    uses: [
      {
        picture: "ships",
        lesson: "splines",
        title: "Shipbuilding",
        text: 'A spline was a thin lath of wood for drawing the lines of a hull: held by weights, and bent no more than it has to be in between. In German it is called <i lang="de">Straklatte</i>. This is where it began.',
      },
      {
        picture: "cad",
        lesson: "bezier",
        title: "CAD",
        text: "Around 1960 car bodies were computed for the first time. Paul de Casteljau at Citroën and Pierre Bézier at Renault each found the same curve for it.",
      },
      {
        picture: "design",
        lesson: "continuity",
        title: "Industrial design",
        text: "Whether a surface is right shows in its reflections. Where two pieces merely meet without a crease, the reflection has one; only equal curvature lets it run on smoothly.",
      },
      {
        picture: "film",
        lesson: "surfaces",
        title: "Film",
        text: "On the screen, skin, cloth and water are often surfaces that hang on a net of a few points. The points are moved; the surface follows.",
      },
      {
        picture: "camera",
        lesson: "splines",
        title: "Camera paths",
        text: "A camera has to fly through a few given places. A spline computes the way between them, and how smooth it is decides whether the flight jerks.",
      },
      {
        picture: "animation",
        lesson: "hermite",
        title: "Animation",
        text: "A movement is a curve, too: a value over time. Its slope is the speed, and whoever sets the tangents decides how something starts and how it comes to rest.",
      },
    ],
    moreIn: "More in:",
    mapTitle: "The course",
    mapIntro:
      "Each lesson shows which others it builds on. If you know some of it already, start where it becomes new.",
    buildsOn: "Builds on:",
    minutes: (minutes) => `${minutes} minutes`,
    addition: "Addition",
    howTitle: "How to read it",
    how: [
      [
        "Move",
        "A point with a ring around it can be moved: with the mouse, with a finger or with the arrow keys. Every step can be undone.",
      ],
      [
        "Set",
        "Words with a dotted line below them put the figure into the state that the sentence speaks of, so that each claim can be checked on the spot.",
      ],
      ["Predict", "First guess, then look. Whoever has committed to an answer looks more closely."],
    ],
  },
};
