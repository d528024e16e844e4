import "virtual:theme.css";
import "../styles/embed.css";
import { demos } from "../../demos/index.ts";
import { defineCurveDemo } from "../../player/index.ts";
import { LANGS } from "../../words/words.ts";

// The language: as the query asks, else the browser's, else German. Known before the figure comes.
const asked = new URLSearchParams(location.search).get("lang");
const wanted = [asked ?? "", ...navigator.languages].map((language) => language.slice(0, 2).toLowerCase());
const lang = LANGS.find((one) => one === wanted.find((code) => code === "de" || code === "en")) ?? "de";
document.documentElement.lang = lang;
document.title = document.querySelector(`h1 [lang="${lang}"]`)?.textContent ?? document.title;

defineCurveDemo(demos, { embedded: true });
