import { type Camera, FLAT, flatView } from "../../scene/camera.ts";
import { wording } from "../../scene/label.ts";
import { formatNumber } from "../../words/numbers.ts";
import { inBoth, type Words } from "../../words/words.ts";
import { areRows, readRows } from "../coordinates.ts";
import { clamp, roundTo, writeNumber } from "../number-text.ts";
import { bad, type Field, good, type Param, type Read } from "../param.ts";

/** How much nearer and farther than at first one may go. */
const ZOOM = 8;

/** Decimals that orbiting keeps: a tenth of a degree, a thousandth of the distance. */
const ANGLE_DECIMALS = 1;

const PARTS: readonly { readonly id: string; readonly label: Words; readonly step: number }[] = [
  { id: "yaw", label: { de: "Drehung in Grad", en: "turn in degrees" }, step: 1 },
  { id: "pitch", label: { de: "Neigung in Grad", en: "tilt in degrees" }, step: 1 },
  { id: "distance", label: { de: "Entfernung", en: "distance" }, step: 0.01 },
];

/**
 * Where space is looked at from: the parameter that `defineDemo` gives to every demo with a window into space. Written
 * `yaw,pitch,distance`, or by the name of a flat view.
 */
export function camera(initial: Camera): Param<Camera> {
  const usual = initial[2];
  const ranges = [
    [-360, 360],
    [-90, 90],
    [usual / ZOOM, usual * ZOOM],
  ] as const;
  const decimals = Math.max(0, 3 - Math.floor(Math.log10(usual)));
  const named = (name: unknown): Camera | null =>
    typeof name === "string" && Object.hasOwn(FLAT, name)
      ? [...FLAT[name as keyof typeof FLAT], usual]
      : null;
  const refuse = (): Read<Camera> => {
    const span = (k: number, lang: "de" | "en") =>
      ranges[k]!.map((end) => formatNumber(end, lang, 3)).join(" … ");
    return bad(
      `erwartet wird top, front, side oder Drehung,Neigung,Entfernung mit ${[0, 1, 2].map((k) => span(k, "de")).join("; ")}`,
      `expected top, front, side or yaw,pitch,distance within ${[0, 1, 2].map((k) => span(k, "en")).join("; ")}`,
    );
  };
  const check = (value: unknown): Read<Camera> => {
    const flat = named(value);
    if (flat) return good(flat);
    return areRows([value], 3, ranges)
      ? good([...(value as readonly number[])] as unknown as Camera)
      : refuse();
  };
  const round = ([yaw, pitch, distance]: Camera): Camera => [
    roundTo(wrapped(yaw), ANGLE_DECIMALS),
    clamp(roundTo(pitch, ANGLE_DECIMALS), -90, 90),
    clamp(roundTo(distance, decimals), ranges[2][0], ranges[2][1]),
  ];
  return {
    type: "camera",
    label: { de: "Blickrichtung", en: "Viewpoint" },
    initial,
    read: (text) => {
      const rows = named(text) ? null : readRows(text);
      return rows?.length === 1 ? check(rows[0]) : check(text);
    },
    write: (value) => {
      const flat = value[2] === usual ? flatView(value) : null;
      return flat ?? value.map(writeNumber).join(",");
    },
    accept: check,
    round,
    // The short way round.
    between: (a, b, share) => [
      a[0] + wrapped(b[0] - a[0]) * share,
      a[1] + (b[1] - a[1]) * share,
      a[2] * (b[2] / a[2]) ** share,
    ],
    handles: () => [],
    fields: (id, value) =>
      PARTS.map(
        (part, k): Field<Camera> => ({
          kind: "number",
          id: `${id}.${part.id}`,
          group: wording({ de: "Blickrichtung", en: "Viewpoint" }),
          label: wording(part.label),
          value: value[k]!,
          min: k === 0 ? -180 : ranges[k]![0],
          max: k === 0 ? 180 : ranges[k]![1],
          step: part.step,
          put: (next) =>
            value.map((x, i) =>
              i === k ? clamp(next, ranges[k]![0], ranges[k]![1]) : x,
            ) as unknown as Camera,
        }),
      ),
    actions: () => [],
    notation: () =>
      inBoth((lang) =>
        lang === "de"
          ? "top | front | side | Drehung,Neigung,Entfernung"
          : "top | front | side | yaw,pitch,distance",
      ),
  };
}

/** The same direction with a yaw above −180 and up to 180 degrees. */
export function wrapped(yaw: number): number {
  const turned = ((yaw % 360) + 360) % 360;
  return turned > 180 ? turned - 360 : turned;
}
