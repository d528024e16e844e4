import { type Camera, type FlatView, flatView } from "../scene/camera.ts";
import { formatNumber } from "../words/numbers.ts";
import { inBoth, type Words } from "../words/words.ts";
import { wrapped } from "./params/camera.ts";

const FLAT_NAMES: Readonly<Record<FlatView, Words>> = {
  top: { de: "Ansicht von oben: x nach rechts, y nach oben.", en: "Seen from above: x to the right, y up." },
  front: {
    de: "Ansicht von vorn: x nach rechts, z nach oben.",
    en: "Seen from the front: x to the right, z up.",
  },
  side: {
    de: "Ansicht von rechts: y nach rechts, z nach oben.",
    en: "Seen from the right: y to the right, z up.",
  },
};

/** A figure's description followed by where it is looked at from. */
export function describeCamera(description: Words, camera: Camera): Words {
  const seen = viewpoint(camera);
  return inBoth((lang) => `${description[lang]} ${seen[lang]}`);
}

/** In words, where space is looked at from. */
export function viewpoint(camera: Camera): Words {
  const flat = flatView(camera);
  if (flat) return FLAT_NAMES[flat];
  const yaw = wrapped(camera[0]);
  return inBoth((lang) => {
    const [turn, tilt] = [Math.abs(yaw), Math.abs(camera[1])].map((x) => formatNumber(x, lang, 0));
    if (lang === "de") {
      const side =
        yaw === 0 ? "von vorn" : `von vorn um ${turn}° nach ${yaw > 0 ? "rechts" : "links"} gedreht`;
      return `Blick ${side}, ${tilt}° von ${camera[1] < 0 ? "unten" : "oben"}.`;
    }
    const side =
      yaw === 0 ? "from the front" : `turned ${turn}° to the ${yaw > 0 ? "right" : "left"} of the front`;
    return `Seen ${side}, ${tilt}° from ${camera[1] < 0 ? "below" : "above"}.`;
  });
}
