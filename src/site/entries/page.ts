import "virtual:theme.css";
import "virtual:katex.css";
import "../styles/page.css";
import { contents } from "../contents.ts";
import { figureHash } from "../figure-hash.ts";
import { forwardToChosen, languageLinks } from "../language.ts";
import { lighting } from "../lighting.ts";
import { liveNumbers } from "../live-numbers.ts";
import { loadPlayerNear } from "../player.ts";
import { prediction } from "../predictions.ts";
import { scrollBoxes } from "../scroll-boxes.ts";
import { stateLinks } from "../state-links.ts";
import { symbols } from "../symbols.ts";
import { symbolsList } from "../symbols-list.ts";
import { themeSwitch } from "../theme.ts";

const main = document.querySelector("main")!;
const nav = document.getElementById("contents");

if (document.body.classList.contains("chooser-page")) forwardToChosen();
for (const button of document.querySelectorAll<HTMLElement>(".theme-switch")) themeSwitch(button);
languageLinks(document.querySelectorAll<HTMLAnchorElement>("a[data-language]"));
if (nav) contents(nav, main);
scrollBoxes(main.querySelectorAll<HTMLElement>("[data-label]"));
stateLinks(main);
const lang = document.documentElement.lang === "en" ? "en" : "de";
const lights = lighting(main);
symbols(main, lights);
for (const button of main.querySelectorAll<HTMLButtonElement>(".symbols-button"))
  symbolsList(button, lang, lights);
liveNumbers(main, lang);
for (const block of main.querySelectorAll<HTMLElement>(".predict")) prediction(block, lang);
figureHash(main);
loadPlayerNear([...main.querySelectorAll("curve-demo")]);
