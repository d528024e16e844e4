import {
  boolean,
  choice,
  defineDemo,
  grid,
  list,
  net,
  number,
  points,
  stroke,
  vector,
} from "../../src/demo/index.ts";
import { polyline } from "../../src/scene/draw.ts";
import { symbol } from "../../src/scene/label.ts";

const label = { de: "Wert", en: "value" };

/** A demo with a parameter of every kind. */
export const sample = defineDemo({
  id: "sample",
  title: { de: "Muster", en: "Sample" },
  params: {
    t: number({ initial: 0.5, min: 0, max: 1, step: 0.01, label, animate: 2, primary: true }),
    n: number({ initial: 3, min: 1, max: 9, step: 1, whole: true, label }),
    hull: boolean({ initial: true, label }),
    mode: choice({
      initial: "a",
      label,
      options: [
        { id: "a", label },
        { id: "b-c", label },
      ],
    }),
    points: points({
      initial: [
        [0, 0],
        [1, 2],
        [3, 1],
      ],
      min: 2,
      max: 5,
      x: [-10, 10],
      y: [-10, 10],
      label,
    }),
    m: vector({
      initial: [1, 0],
      label,
      symbol: symbol("m", 0),
      scale: 0.5,
      anchor: (state) => (state.points as readonly (readonly number[])[])[0]!,
    }),
    nodes: list({ initial: [0, 1, 2], min: 1, max: 4, range: [-5, 5], label, letter: "t" }),
    values: grid({
      initial: [
        [1, 2],
        [3, 4],
      ],
      range: [-9, 9],
      label,
      letter: "v",
    }),
    patch: net({
      initial: [
        [
          [0, 0, 0],
          [1, 0, 0],
        ],
        [
          [0, 1, 0],
          [1, 1, 1],
        ],
      ],
      view: "plane",
      label,
    }),
    drawing: stroke({ x: [-10, 10], y: [-10, 10], label }),
  },
  views: { plane: { label, x: [0, 5], y: [0, 5], height: 0.6 } },
  settle: (next) => ({ ...next, nodes: [...next.nodes].sort((a, b) => a - b) }),
  values: ({ t }) => ({ t }),
  scene: ({ points }) => ({ plane: [polyline("polygon", "control-polygon", points)] }),
  describe: () => ({ de: "Ein Muster.", en: "A sample." }),
  states: {
    half: { t: 0.5 },
    far: {
      t: 1,
      points: [
        [5, 5],
        [1, 1],
      ],
    },
  },
});
