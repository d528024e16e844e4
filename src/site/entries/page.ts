import "virtual:theme.css";
import "virtual:katex.css";
import "../styles/page.css";
import { contents } from "../contents.ts";
import { figureHash } from "../figure-hash.ts";
import { forwardToChosen, languageLinks } from "../language.ts";
import { loadPlayerNear } from "../player.ts";
import { scrollBoxes } from "../scroll-boxes.ts";
import { stateLinks } from "../state-links.ts";
import { themeSwitch } from "../theme.ts";

const main = document.querySelector("main")!;
const nav = document.getElementById("contents");

if (document.body.classList.contains("chooser-page")) forwardToChosen();
for (const button of document.querySelectorAll<HTMLElement>(".theme-switch")) themeSwitch(button);
languageLinks(document.querySelectorAll<HTMLAnchorElement>("a[data-language]"));
if (nav) contents(nav, main);
scrollBoxes(main.querySelectorAll<HTMLElement>("[data-label]"));
stateLinks(main);
figureHash(main);
loadPlayerNear([...main.querySelectorAll("curve-demo")]);
