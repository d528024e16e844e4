import {
  add,
  bernstein,
  bernsteinAll,
  bernsteinDerivative,
  bezierDerivative,
  bezierPoint,
  binomial,
  combine,
  deCasteljau,
  elevateDegree,
  hodograph,
  lerp,
  type Point,
  scale,
  sub,
} from "../math/index.ts";
import { type Draw, type Identity, sum } from "./identity.ts";

/** A curve of random degree, and a parameter inside. */
function curve(draw: Draw, least = 1): { n: number; c: readonly Point[]; t: number } {
  const n = draw.integer(least, 8);
  return { n, c: draw.points(n + 1), t: draw.number(0, 1) };
}

const indices = (n: number) => Array.from({ length: n + 1 }, (_, i) => i);

/** The formulas of the lesson on Bézier curves. */
export const bezier: Readonly<Record<string, Identity>> = {
  "bezier-linear": {
    formula: "p(t) = (1-t) c_0 + t c_1",
    sides: (draw) => {
      const [c, t] = [draw.points(2), draw.number(0, 1)];
      return [[combine([1 - t, t], c), bezierPoint(c, t)]];
    },
  },
  "bezier-quadratic": {
    formula: String.raw`\begin{aligned}
p(t) &= (1-t)\bigl((1-t) c_0 + t c_1\bigr) + t \bigl((1-t) c_1 + t c_2\bigr) \\
     &= (1-t)^2 c_0 + 2t(1-t) c_1 + t^2 c_2
\end{aligned}`,
    sides: (draw) => {
      const [c, t] = [draw.points(3), draw.number(0, 1)];
      const twice = lerp(lerp(c[0]!, c[1]!, t), lerp(c[1]!, c[2]!, t), t);
      const point = bezierPoint(c, t);
      return [
        [twice, point],
        [combine([(1 - t) ** 2, 2 * t * (1 - t), t ** 2], c), point],
      ];
    },
  },
  "bezier-cubic": {
    formula: "p(t) = (1-t)^3 c_0 + 3t(1-t)^2 c_1 + 3t^2(1-t) c_2 + t^3 c_3 .",
    sides: (draw) => {
      const [c, t] = [draw.points(4), draw.number(0, 1)];
      const s = 1 - t;
      return [[combine([s ** 3, 3 * t * s ** 2, 3 * t ** 2 * s, t ** 3], c), bezierPoint(c, t)]];
    },
  },
  "binomial-theorem": {
    formula: String.raw`1 = \bigl(t + (1-t)\bigr)^n = \sum_{i=0}^n \binom{n}{i} t^i (1-t)^{n-i},
\qquad \binom{n}{i} = \frac{n!}{i! (n-i)!}`,
    sides: (draw) => {
      const [n, t] = [draw.integer(0, 12), draw.number(0, 1)];
      const factorial = (k: number): number => (k < 2 ? 1 : k * factorial(k - 1));
      const i = draw.integer(0, n);
      return [
        [1, (t + (1 - t)) ** n],
        [1, sum(0, n, (k) => binomial(n, k) * t ** k * (1 - t) ** (n - k))],
        [binomial(n, i), factorial(n) / (factorial(i) * factorial(n - i))],
      ];
    },
  },
  "bernstein-definition": {
    formula: String.raw`B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}`,
    sides: (draw) => {
      const [n, t] = [draw.integer(0, 12), draw.number(0, 1)];
      const i = draw.integer(0, n);
      return [[binomial(n, i) * t ** i * (1 - t) ** (n - i), bernstein(n, i, t)]];
    },
  },
  "power-in-bernstein": {
    formula: String.raw`t^k = \sum_{i=k}^n \frac{\binom{i}{k}}{\binom{n}{k}} B_i^n(t) .`,
    sides: (draw) => {
      const [n, t] = [draw.integer(0, 10), draw.number(0, 1)];
      const k = draw.integer(0, n);
      return [[t ** k, sum(k, n, (i) => (binomial(i, k) / binomial(n, k)) * bernstein(n, i, t))]];
    },
  },
  "smooth-step": {
    formula: "3t^2 - 2t^3 = 3t^2(1-t) + t^3 = B_2^3(t) + B_3^3(t)",
    sides: (draw) => {
      const t = draw.number(0, 1);
      const basis = bernstein(3, 2, t) + bernstein(3, 3, t);
      return [
        [3 * t ** 2 - 2 * t ** 3, basis],
        [3 * t ** 2 * (1 - t) + t ** 3, basis],
      ];
    },
  },
  "bezier-definition": {
    formula: String.raw`p(t) = \sum_{i=0}^n c_i B_i^n(t), \qquad 0 \le t \le 1 .`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      return [[combine(bernsteinAll(n, t), c), bezierPoint(c, t)]];
    },
  },
  "one-point-moved": {
    formula: String.raw`\tilde p(t) - p(t) = B_i^n(t) \bigl(\tilde c_i - c_i\bigr)`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      const i = draw.integer(0, n);
      const [to] = draw.points(1);
      const moved = c.map((point, k) => (k === i ? to! : point));
      return [[sub(bezierPoint(moved, t), bezierPoint(c, t)), scale(sub(to!, c[i]!), bernstein(n, i, t))]];
    },
  },
  "affine-invariance": {
    formula: String.raw`A p(t) + b = \sum_{i=0}^n A c_i B_i^n(t) + \sum_{i=0}^n b B_i^n(t) = \sum_{i=0}^n (A c_i + b) B_i^n(t) .`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      const [first, second, b] = draw.points(3);
      const A = ([x, y]: Point): Point => [
        first![0]! * x! + first![1]! * y!,
        second![0]! * x! + second![1]! * y!,
      ];
      const weights = bernsteinAll(n, t);
      const left = add(A(bezierPoint(c, t)), b!);
      const two = add(
        combine(weights, c.map(A)),
        combine(
          weights,
          c.map(() => b!),
        ),
      );
      return [
        [left, two],
        [
          left,
          bezierPoint(
            c.map((point) => add(A(point), b!)),
            t,
          ),
        ],
      ];
    },
  },
  "bernstein-derivative": {
    formula: String.raw`\frac{\mathrm{d}}{\mathrm{d}t} B_i^n(t) = n \bigl(B_{i-1}^{n-1}(t) - B_i^{n-1}(t)\bigr) .`,
    sides: (draw) => {
      const [n, t] = [draw.integer(1, 10), draw.number(0, 1)];
      const i = draw.integer(0, n);
      const lower = (k: number) => (k < 0 || k > n - 1 ? 0 : bernstein(n - 1, k, t));
      const h = 1e-5;
      const inside = h + t * (1 - 2 * h);
      const difference = (bernstein(n, i, inside + h) - bernstein(n, i, inside - h)) / (2 * h);
      return [
        [bernsteinDerivative(n, i, t), n * (lower(i - 1) - lower(i))],
        // The module's derivative is the derivative: to what a difference quotient can tell.
        [Math.round(difference * 1e4) / 1e4, Math.round(bernsteinDerivative(n, i, inside) * 1e4) / 1e4],
      ];
    },
    tolerance: 2e-4,
  },
  "bezier-derivative": {
    formula: String.raw`p'(t) = \sum_{i=0}^{n-1} n (c_{i+1} - c_i) B_i^{n-1}(t) .`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      const legs = indices(n - 1).map((i) => scale(sub(c[i + 1]!, c[i]!), n));
      return [[combine(bernsteinAll(n - 1, t), legs), bezierDerivative(c, t)]];
    },
  },
  "end-derivatives": {
    formula: String.raw`p'(0) = n (c_1 - c_0), \qquad p'(1) = n (c_n - c_{n-1})`,
    sides: (draw) => {
      const { n, c } = curve(draw);
      return [
        [bezierDerivative(c, 0), scale(sub(c[1]!, c[0]!), n)],
        [bezierDerivative(c, 1), scale(sub(c[n]!, c[n - 1]!), n)],
      ];
    },
  },
  "start-from-rest": {
    formula: String.raw`p(t) - c_0 \approx \binom{n}{k} t^k (c_k - c_0) .`,
    // The quotient by t^k tends to the right side; how fast, the next term tells. With c_0 in the origin, which affine
    // invariance allows, nothing is lost by subtracting.
    sides: (draw) => {
      const { n, c } = curve(draw);
      const k = draw.integer(1, n);
      const resting = c.map((point, i) => (i < k ? [0, 0] : point));
      const t = 1e-4;
      const left = bezierPoint(resting, t);
      return [[scale(left, t ** -k), scale(resting[k]!, binomial(n, k))]];
    },
    tolerance: 0.06,
  },
  "casteljau-recursion": {
    formula: String.raw`b_i^0 = c_i, \qquad b_i^r = (1-t) b_i^{r-1} + t b_{i+1}^{r-1}, \qquad p(t) = b_0^n .`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      const b = deCasteljau(c, t);
      const r = draw.integer(1, n);
      const i = draw.integer(0, n - r);
      return [
        [b[0]!, c],
        [b[r]![i]!, add(scale(b[r - 1]![i]!, 1 - t), scale(b[r - 1]![i + 1]!, t))],
        [b[n]![0]!, combine(bernsteinAll(n, t), c)],
      ];
    },
  },
  "derivative-from-last-leg": {
    formula: String.raw`p'(t) = n \bigl(b_1^{n-1} - b_0^{n-1}\bigr) .`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      const [b0, b1] = deCasteljau(c, t)[n - 1]!;
      return [[scale(sub(b1!, b0!), n), combine(bernsteinAll(n - 1, t), hodograph(c))]];
    },
  },
  "degree-elevation": {
    formula: String.raw`c_i^{*} = \frac{i}{n+1} c_{i-1} + \Bigl(1 - \frac{i}{n+1}\Bigr) c_i, \qquad i = 0, 1, \dots, n+1 .`,
    sides: (draw) => {
      const { n, c, t } = curve(draw);
      const share = (i: number) => i / (n + 1);
      const stars = indices(n + 1).map((i) => {
        if (i === 0) return c[0]!;
        if (i === n + 1) return c[n]!;
        return add(scale(c[i - 1]!, share(i)), scale(c[i]!, 1 - share(i)));
      });
      return [
        [stars, elevateDegree(c)],
        [bezierPoint(stars, t), bezierPoint(c, t)],
      ];
    },
  },
  "example-control-points": {
    formula: String.raw`\begin{aligned}
c_0 &= (0, 0), & c_1 &= c_0 + \tfrac13 (3, 6) = (1, 2), \\
c_3 &= (4, 0), & c_2 &= c_3 - \tfrac13 (3, -6) = (3, 2)
\end{aligned}`,
    sides: (draw) => {
      const c = EXAMPLE;
      const t = draw.number(0, 1);
      return [
        [c[1]!, add(c[0]!, scale([3, 6], 1 / 3))],
        [c[2]!, sub(c[3]!, scale([3, -6], 1 / 3))],
        [bezierDerivative(c, 0), [3, 6]],
        [bezierDerivative(c, 1), [3, -6]],
        // The curve that the figure beside it draws.
        [bezierPoint(c, t), combine(bernsteinAll(3, t), c)],
      ];
    },
  },
  "example-triangle": {
    formula: String.raw`\begin{array}{lllll}
(0, 0) \\[3pt]
(1, 2) & (\tfrac12, 1) \\[3pt]
(3, 2) & (2, 2) & (\tfrac54, \tfrac32) \\[3pt]
(4, 0) & (\tfrac72, 1) & (\tfrac{11}{4}, \tfrac32) & (2, \tfrac32) = p(\tfrac12)
\end{array}`,
    sides: () => {
      const rows = [
        [
          [0, 0],
          [1, 2],
          [3, 2],
          [4, 0],
        ],
        [
          [1 / 2, 1],
          [2, 2],
          [7 / 2, 1],
        ],
        [
          [5 / 4, 3 / 2],
          [11 / 4, 3 / 2],
        ],
        [[2, 3 / 2]],
      ];
      return [
        [rows, deCasteljau(EXAMPLE, 1 / 2)],
        [rows[3]![0]!, bezierPoint(EXAMPLE, 1 / 2)],
      ];
    },
  },
};

/** The four control points of the worked example. */
const EXAMPLE: readonly Point[] = [
  [0, 0],
  [1, 2],
  [3, 2],
  [4, 0],
];
