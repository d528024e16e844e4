import { bezierDerivative, bezierPoint } from "./bezier.ts";
import { checkPoints, checkPositive } from "./check.ts";
import { distance, dot, lerp, norm, type Point, sub } from "./point.ts";
import { splitBezier } from "./split-bezier.ts";

/** A common point of two curves: parameter t on the first, u on the second. */
export type Intersection = { readonly t: number; readonly u: number; readonly point: Point };

/** A piece of a Bézier curve, over the `index`-th part of [0, 1] at some level of halving; halved when needed. */
type Piece = {
  readonly points: readonly Point[];
  readonly index: number;
  halves?: readonly [Piece, Piece];
};

/** The last level of halving: pieces over 2⁻²⁰ of the parameter. */
const lastLevel = 20;

/** More pairs of pieces than this are left only between curves that share infinitely many points. */
const mostPairs = 2000;

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
    const next: [Piece, Piece][] = [];
    for (const [p, q] of pairs) {
      for (const left of halvesOf(p)) {
        for (const right of halvesOf(q)) {
          if (!separated(left.points, right.points, margin)) next.push([left, right]);
        }
      }
    }
    if (next.length > mostPairs) return null;
    pairs = next;
  }
  const width = 2 ** -lastLevel;
  const found = clusters(pairs).map((cluster) => {
    const starts = cluster.map(([p, q]) => {
      const [t, u] = [(p.index + 0.5) * width, (q.index + 0.5) * width];
      return { t, u, gap: distance(bezierPoint(a, t), bezierPoint(b, u)) };
    });
    const start = starts.reduce((best, other) => (other.gap < best.gap ? other : best));
    return refine(a, b, start.t, start.u);
  });
  return found
    .filter(({ gap }) => gap <= accuracy)
    .map(({ t, u }) => ({ t, u, point: lerp(bezierPoint(a, t), bezierPoint(b, u), 0.5) }))
    .sort((one, other) => one.t - other.t || one.u - other.u);
}

function halvesOf(piece: Piece): readonly [Piece, Piece] {
  if (!piece.halves) {
    const [left, right] = splitBezier(piece.points, 0.5);
    piece.halves = [
      { points: left, index: 2 * piece.index },
      { points: right, index: 2 * piece.index + 1 },
    ];
  }
  return piece.halves;
}

/** Whether a line separates the two control polygons, and so the curves, by more than `margin`. */
function separated(p: readonly Point[], q: readonly Point[], margin: number): boolean {
  return (
    separatedAlong(1, 0, p, q, margin) ||
    separatedAlong(0, 1, p, q, margin) ||
    separatedAcrossChord(p, p, q, margin) ||
    separatedAcrossChord(q, p, q, margin)
  );
}

function separatedAcrossChord(
  chord: readonly Point[],
  p: readonly Point[],
  q: readonly Point[],
  margin: number,
): boolean {
  const [x, y] = sub(chord.at(-1)!, chord[0]!) as [number, number];
  return separatedAlong(-y, x, p, q, margin * norm([x, y]));
}

/** Whether the projections on the direction (x, y) are more than `margin` apart. */
function separatedAlong(
  x: number,
  y: number,
  p: readonly Point[],
  q: readonly Point[],
  margin: number,
): boolean {
  let [minP, maxP, minQ, maxQ] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const point of p) {
    const along = x * point[0]! + y * point[1]!;
    if (along < minP) minP = along;
    if (along > maxP) maxP = along;
  }
  for (const point of q) {
    const along = x * point[0]! + y * point[1]!;
    if (along < minQ) minQ = along;
    if (along > maxQ) maxQ = along;
  }
  return minQ - maxP > margin || minP - maxQ > margin;
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
