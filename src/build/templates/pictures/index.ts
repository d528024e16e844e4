import type { Html } from "../types.ts";
import { animation } from "./animation.ts";
import { cad } from "./cad.ts";
import { camera } from "./camera.ts";
import { design } from "./design.ts";
import { film } from "./film.ts";
import { ships } from "./ships.ts";

const PICTURES = { ships, cad, design, film, camera, animation };
export type Picture = keyof typeof PICTURES;

/** A small drawing of 240 × 150 for the front page. The words beside it say what it shows. */
export function picture(name: Picture): Html {
  return `<svg class="picture" viewBox="0 0 240 150" aria-hidden="true" focusable="false">${PICTURES[name]}</svg>`;
}
