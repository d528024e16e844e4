import {
  bezierPoint,
  bezierPointInto,
  bezierPointsInto,
  cubicSpline,
  type Point,
  patchNormalInto,
  patchPointInto,
  patchTessellator,
  toFlat,
  toFlatNet,
} from "../src/math/index.ts";
import { type Contender, measure } from "./measure.ts";
import type { Peers } from "./peers.ts";

/** A bar: what is compared, the ratio measured, the ratio demanded. */
export type Bar = {
  readonly what: string;
  readonly ratio: number;
  readonly demand: "at least" | "at most" | "no bar";
  readonly bound: number;
};

const cubic: Point[] = [
  [0, 0],
  [1, 3],
  [4, 3],
  [5, 0],
];
const septic: Point[] = [
  [0, 0],
  [1, 4],
  [1, -4],
  [2, 5],
  [4, -5],
  [5, 2],
  [6, 3],
  [7, -1],
];
const count = 2000;
const ts = Float64Array.from({ length: count }, (_, k) => k / (count - 1));

/** A contender with a loop of its own over all parameters, so that the compiler treats each on its own merits. */
function loop(name: string, run: () => number): Contender {
  return { name, operations: count, run };
}

/** The drawn cubic: the batch form against a loop written by hand, `…Into` against other libraries. */
export function cubicBars({ Bezier, three }: Peers): Bar[] {
  const flat = toFlat(cubic);
  const out = new Float64Array(2 * count);
  const vectors = cubic.map((p) => new three.Vector2(p[0], p[1]));
  const threeCurve = new three.CubicBezierCurve(vectors[0], vectors[1], vectors[2], vectors[3]);
  const target = new three.Vector2();
  const peer = new Bezier(cubic.flat());
  const times = measure([
    loop("batch", () => {
      bezierPointsInto(out, flat, 2, ts);
      return out[count]!;
    }),
    loop("by hand", () => {
      cubicByHand(out, flat, ts);
      return out[count]!;
    }),
    loop("into", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) {
        bezierPointInto(out, flat, 2, ts[k]!);
        sum += out[0]!;
      }
      return sum;
    }),
    loop("scheme", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) sum += bezierPoint(cubic, ts[k]!)[0]!;
      return sum;
    }),
    loop("bezier-js", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) sum += peer.get(ts[k]!).x;
      return sum;
    }),
    loop("three", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) sum += threeCurve.getPoint(ts[k]!, target).x;
      return sum;
    }),
  ]);
  return [
    {
      what: "cubic, batch: time against a loop by hand",
      ratio: times.batch! / times["by hand"]!,
      demand: "at most",
      bound: 1.5,
    },
    {
      what: "cubic, …Into: times as fast as bezier-js get",
      ratio: times["bezier-js"]! / times.into!,
      demand: "at least",
      bound: 2.5,
    },
    {
      what: "cubic, …Into: times as fast as three getPoint",
      ratio: times.three! / times.into!,
      demand: "no bar",
      bound: 0,
    },
    {
      what: "cubic, readable scheme: times as slow as …Into",
      ratio: times.scheme! / times.into!,
      demand: "no bar",
      bound: 0,
    },
  ];
}

function cubicByHand(out: Float64Array, c: Float64Array, parameters: Float64Array): void {
  const [x0, y0, x1, y1, x2, y2, x3, y3] = c as unknown as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  for (let k = 0; k < parameters.length; k++) {
    const t = parameters[k]!;
    const s = 1 - t;
    const [a, b, d, e] = [s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t];
    out[2 * k] = a * x0 + b * x1 + d * x2 + e * x3;
    out[2 * k + 1] = a * y0 + b * y1 + d * y2 + e * y3;
  }
}

/** High degrees. */
export function degreeBars({ Bezier }: Peers): Bar[] {
  const flat = toFlat(septic);
  const out = new Float64Array(2);
  const peer = new Bezier(septic.flat());
  const ofDegree = (n: number): Contender => {
    const data = toFlat(Array.from({ length: n + 1 }, (_, i) => [i, Math.sin(i)]));
    return loop(`degree ${n}`, () => intoLoop(data, out));
  };
  const times = measure([
    loop("into", () => intoLoop(flat, out)),
    loop("bezier-js", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) sum += peer.get(ts[k]!).x;
      return sum;
    }),
    ...[8, 16, 32].map(ofDegree),
  ]);
  const growth = Math.max(
    times["degree 16"]! / times["degree 8"]!,
    times["degree 32"]! / times["degree 16"]!,
  );
  return [
    {
      what: "degree 7, …Into: times as fast as bezier-js get",
      ratio: times["bezier-js"]! / times.into!,
      demand: "at least",
      bound: 100,
    },
    { what: "twice the degree (8, 16, 32): times the cost", ratio: growth, demand: "at most", bound: 4 },
  ];
}

function intoLoop(data: Float64Array, out: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < count; k++) {
    bezierPointInto(out, data, 2, ts[k]!);
    sum += out[0]!;
  }
  return sum;
}

const net: Point[][] = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => [i, j, Math.sin(i) * Math.cos(j)]));

/** Bicubic patches: single points and normals against verb, a grid with normals against the points of `nurbs`. */
export function patchBars({ verb, nurbs }: Peers): Bar[] {
  const flat = toFlatNet(net);
  const out = new Float64Array(3);
  const ends = [0, 0, 0, 0, 1, 1, 1, 1];
  const surface = verb.geom.NurbsSurface.byKnotsControlPointsWeights(3, 3, ends, ends, net);
  const times = measure([
    loop("point", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) {
        patchPointInto(out, flat, 3, 3, ts[k]!, 0.3);
        sum += out[0]!;
      }
      return sum;
    }),
    loop("verb point", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) sum += surface.point(ts[k]!, 0.3)[0]!;
      return sum;
    }),
    loop("normal", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) {
        patchNormalInto(out, flat, 3, 3, ts[k]!, 0.3);
        sum += out[0]!;
      }
      return sum;
    }),
    loop("verb normal", () => {
      let sum = 0;
      for (let k = 0; k < count; k++) sum += surface.normal(ts[k]!, 0.3)[0]!;
      return sum;
    }),
  ]);

  const steps = 40;
  const positions = new Float64Array(3 * (steps + 1) ** 2);
  const normals = new Float64Array(positions.length);
  const tessellate = patchTessellator(3, 3, steps, steps);
  const peer = nurbs({ points: net, degree: [3, 3], knots: [ends, ends] });
  const point: number[] = [];
  const operations = (steps + 1) ** 2;
  const grid = measure([
    {
      name: "grid with normals",
      operations,
      run: () => {
        tessellate(flat, positions, normals);
        return positions[4]! + normals[4]!;
      },
    },
    {
      name: "nurbs",
      operations,
      run: () => {
        let sum = 0;
        for (let a = 0; a <= steps; a++) {
          for (let b = 0; b <= steps; b++) sum += peer.evaluate(point, a / steps, b / steps)[0]!;
        }
        return sum;
      },
    },
  ]);
  return [
    {
      what: "bicubic point: times as fast as verb",
      ratio: times["verb point"]! / times.point!,
      demand: "at least",
      bound: 5,
    },
    {
      what: "bicubic unit normal: times as fast as verb",
      ratio: times["verb normal"]! / times.normal!,
      demand: "at least",
      bound: 20,
    },
    {
      what: "grid with normals: times as fast as nurbs without",
      ratio: grid.nurbs! / grid["grid with normals"]!,
      demand: "at least",
      bound: 3,
    },
  ];
}

/** The cubic spline: ten times the points take ten times as long (a quadratic cost would be a ratio of 10 here). */
export function splineBars(): Bar[] {
  const spline = (n: number): Contender => {
    const nodes = Array.from({ length: n }, (_, i) => i);
    const points = nodes.map((i): Point => [i, Math.sin(i)]);
    const run = (): number => cubicSpline(nodes, points, { type: "natural" }).point(1.5)[0]!;
    return { name: String(n), operations: n, run };
  };
  const times = measure([spline(10_000), spline(100_000), spline(1_000_000)], 5);
  const bar = (what: string, ratio: number): Bar => ({ what, ratio, demand: "at most", bound: 4 });
  return [
    bar("cubic spline: time per point at 10⁵ against 10⁴", times["100000"]! / times["10000"]!),
    bar("cubic spline: time per point at 10⁶ against 10⁵", times["1000000"]! / times["100000"]!),
  ];
}
