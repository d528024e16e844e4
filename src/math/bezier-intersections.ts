import { bezierDerivative, bezierPoint } from "./bezier.ts";
import { checkPoints, checkPositive } from "./check.ts";
import { dot, lerp, norm, type Point, sub } from "./point.ts";
import { splitBezier } from "./split-bezier.ts";

/** A common point of two curves: parameter t on the first, u on the second. */
export type Intersection = { readonly t: number; readonly u: number; readonly point: Point };

/** A piece of a Bézier curve, over the `index`-th part of [0, 1] at some level of halving. */
type Piece = { readonly points: readonly Point[]; readonly index: number };

/** The last level of halving: pieces over 2⁻²⁰ of the parameter. */
const lastLevel = 20;

/** More pairs of pieces than this are left only between curves that share infinitely many points. */
const mostPairs = 5000;

/**
 * The common points of two plane Bézier curves, ascending in t, or `null` if the curves share a whole piece (or one is a
 * single point on the other) and thus have infinitely many parameters in common.
 *
 * Both are halved again and again; a pair of pieces is dropped as soon as a line along an axis or along one of
 * their chords separates their control polygons. Neighbouring pairs that are left make one common point, refined by
 * damped Newton steps. Curves that come as close as `accuracy` (a length) without touching may count as touching;
 * touching points are found once. A self-intersection is not looked for.
 *
 * @throws RangeError if there is no control point, a point is not in the plane, a number is not finite or `accuracy` is
 * not positive.
 */
export function bezierIntersections(
  a: readonly Point[],
  b: readonly Point[],
  accuracy: number,
): Intersection[] | null {
  checkPoints("a", a, 1, 2);
  checkPoints("b", b, 1, 2);
  checkPositive("accuracy", accuracy);
  const margin = 1e-14 * Math.max(...[...a, ...b].map(norm));
  let pairs: [Piece, Piece][] = [
    [
      { points: a, index: 0 },
      { points: b, index: 0 },
    ],
  ];
  for (let level = 0; level < lastLevel; level++) {
    pairs = pairs.flatMap(([p, q]) => {
      const ofQ = halves(q);
      return halves(p).flatMap((left) =>
        ofQ.flatMap((right): [Piece, Piece][] =>
          separated(left.points, right.points, margin) ? [] : [[left, right]],
        ),
      );
    });
    if (pairs.length > mostPairs) return null;
  }
  const width = 2 ** -lastLevel;
  return clusters(pairs)
    .map((cluster) =>
      cluster
        .map(([p, q]) => refine(a, b, (p.index + 0.5) * width, (q.index + 0.5) * width))
        .reduce((best, other) => (other.gap < best.gap ? other : best)),
    )
    .filter(({ gap }) => gap <= accuracy)
    .map(({ t, u }) => ({ t, u, point: lerp(bezierPoint(a, t), bezierPoint(b, u), 0.5) }))
    .sort((one, other) => one.t - other.t || one.u - other.u);
}

function halves({ points, index }: Piece): Piece[] {
  return splitBezier(points, 0.5).map((half, k) => ({ points: half, index: 2 * index + k }));
}

/** Whether a line separates the two control polygons, and so the curves, by more than `margin`. */
function separated(p: readonly Point[], q: readonly Point[], margin: number): boolean {
  return [[1, 0], [0, 1], normalOfChord(p), normalOfChord(q)].some((axis) => {
    const along = (points: readonly Point[]): number[] => points.map((point) => dot(point, axis));
    const [ofP, ofQ] = [along(p), along(q)];
    const gap = Math.max(Math.min(...ofP) - Math.max(...ofQ), Math.min(...ofQ) - Math.max(...ofP));
    return gap > margin * norm(axis);
  });
}

function normalOfChord(points: readonly Point[]): Point {
  const chord = sub(points.at(-1)!, points[0]!);
  return [-chord[1]!, chord[0]!];
}

/** Groups of pairs in which each neighbours another one in both parameters. */
function clusters(pairs: readonly [Piece, Piece][]): [Piece, Piece][][] {
  const left = new Map(pairs.map((pair) => [`${pair[0].index},${pair[1].index}`, pair]));
  const groups: [Piece, Piece][][] = [];
  for (const seed of pairs) {
    const group: [Piece, Piece][] = [];
    const open = [seed];
    for (let pair = open.pop(); pair; pair = open.pop()) {
      const [i, j] = [pair[0].index, pair[1].index];
      if (!left.delete(`${i},${j}`)) continue;
      group.push(pair);
      for (const k of [i - 1, i, i + 1]) {
        for (const l of [j - 1, j, j + 1]) {
          const neighbour = left.get(`${k},${l}`);
          if (neighbour) open.push(neighbour);
        }
      }
    }
    if (group.length > 0) groups.push(group);
  }
  return groups;
}

/** Minimises the distance ‖a(t) − b(u)‖ from a good guess by Levenberg and Marquardt's damped Newton steps. */
function refine(a: readonly Point[], b: readonly Point[], t: number, u: number) {
  let difference = sub(bezierPoint(a, t), bezierPoint(b, u));
  let damping = 1e-12;
  for (let step = 0; step < 60 && damping < 1e12; step++) {
    const da = bezierDerivative(a, t);
    const db = bezierDerivative(b, u);
    const [aa, ab, bb] = [dot(da, da), -dot(da, db), dot(db, db)];
    const [ga, gb] = [dot(da, difference), -dot(db, difference)];
    const extra = damping * (aa + bb);
    const determinant = (aa + extra) * (bb + extra) - ab * ab;
    if (!(determinant > 0)) break;
    const nextT = clamp(t - ((bb + extra) * ga - ab * gb) / determinant);
    const nextU = clamp(u - ((aa + extra) * gb - ab * ga) / determinant);
    const next = sub(bezierPoint(a, nextT), bezierPoint(b, nextU));
    if (norm(next) < norm(difference)) {
      [t, u, difference] = [nextT, nextU, next];
      damping /= 10;
    } else {
      damping = Math.max(damping, 1e-12) * 100;
    }
  }
  return { t, u, gap: norm(difference) };
}

function clamp(t: number): number {
  return Math.min(1, Math.max(0, t));
}
