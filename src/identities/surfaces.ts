import {
  bernsteinAll,
  bezierPatch,
  bezierPoint,
  binomial,
  combine,
  cross,
  dot,
  fundamentalForms,
  norm,
  type Point,
  patchPartial,
  patchPoint,
  scale,
  sphereSurface,
  sub,
  surfaceCurvature,
  surfaceNormal,
} from "../math/index.ts";
import type { Draw, Identity } from "./identity.ts";

/** A net of random degrees in space, and a place in the parameter square. */
function patch(draw: Draw, least = 1) {
  const [m, n] = [draw.integer(least, 5), draw.integer(least, 5)];
  const net = Array.from({ length: m + 1 }, () => draw.points(n + 1, 3));
  return { m, n, net, u: draw.number(0, 1), v: draw.number(0, 1) };
}

/** Σ_i Σ_j a_i · b_j · c_ij, as the double sum says it. */
function doubleSum(net: readonly (readonly Point[])[], a: readonly number[], b: readonly number[]): Point {
  const weights = a.flatMap((x) => b.map((y) => x * y));
  return combine(weights, net.flat());
}

const indices = (n: number) => Array.from({ length: n }, (_, i) => i);

/** The formulas of the lesson on surfaces. */
export const surfaces: Readonly<Record<string, Identity>> = {
  "sphere-parametric": {
    formula: String.raw`S(u, v) = r (\cos u \cos v, \sin u \cos v, \sin v)`,
    sides: (draw) => {
      const [r, u, v] = [draw.number(0.5, 3), draw.number(0, 6.28), draw.number(-1.57, 1.57)];
      const written = [Math.cos(u) * Math.cos(v), Math.sin(u) * Math.cos(v), Math.sin(v)];
      return [[scale(written, r), sphereSurface(r).point(u, v)]];
    },
  },
  "sphere-implicit": {
    formula: "x^2 + y^2 + z^2 = r^2",
    sides: (draw) => {
      const r = draw.number(0.5, 3);
      const [x, y, z] = sphereSurface(r).point(draw.number(0, 6.28), draw.number(-1.57, 1.57));
      return [[x! ** 2 + y! ** 2 + z! ** 2, r ** 2]];
    },
  },
  "unit-normal": {
    formula: String.raw`n = \frac{S_u \times S_v}{\norm{S_u \times S_v}} ,`,
    sides: (draw) => {
      const { net, u, v } = patch(draw);
      const product = cross(patchPartial(net, u, v, 1, 0), patchPartial(net, u, v, 0, 1));
      return [[scale(product, 1 / norm(product)), surfaceNormal(bezierPatch(net), u, v)!]];
    },
  },
  "curve-of-curves": {
    formula: String.raw`q_i(v) = \sum_{j=0}^{n} c_{ij} B_j^n(v), \qquad S(u, v) = \sum_{i=0}^{m} q_i(v) B_i^m(u)`,
    sides: (draw) => {
      const { m, n, net, u, v } = patch(draw);
      const q = net.map((row) => combine(bernsteinAll(n, v), row));
      return [
        ...q.map((point, i) => [point, bezierPoint(net[i]!, v)] as const),
        [combine(bernsteinAll(m, u), q), patchPoint(net, u, v)],
      ];
    },
  },
  "tensor-product": {
    formula: String.raw`S(u, v) = \sum_{i=0}^{m} \sum_{j=0}^{n} c_{ij} B_i^m(u) B_j^n(v) .`,
    sides: (draw) => {
      const { m, n, net, u, v } = patch(draw);
      return [[doubleSum(net, bernsteinAll(m, u), bernsteinAll(n, v)), patchPoint(net, u, v)]];
    },
  },
  "bicubic-patch": {
    formula: String.raw`S(u, v) = \sum_{i=0}^{3} \sum_{j=0}^{3} c_{ij} B_i^3(u) B_j^3(v)`,
    sides: (draw) => {
      const net = Array.from({ length: 4 }, () => draw.points(4, 3));
      const [u, v] = [draw.number(0, 1), draw.number(0, 1)];
      return [[doubleSum(net, bernsteinAll(3, u), bernsteinAll(3, v)), patchPoint(net, u, v)]];
    },
  },
  "patch-edge": {
    formula: String.raw`S(u, 0) = \sum_{i=0}^{m} c_{i0} B_i^m(u) .`,
    sides: (draw) => {
      const { m, net, u } = patch(draw);
      const edge = net.map((row) => row[0]!);
      return [[combine(bernsteinAll(m, u), edge), patchPoint(net, u, 0)]];
    },
  },
  "one-control-point-moved": {
    formula: String.raw`\tilde S(u, v) - S(u, v) = B_i^m(u) B_j^n(v) (\tilde c_{ij} - c_{ij})`,
    sides: (draw) => {
      const { m, n, net, u, v } = patch(draw);
      const [i, j] = [draw.integer(0, m), draw.integer(0, n)];
      const [to] = draw.points(1, 3);
      const moved = net.map((row, k) => row.map((point, l) => (k === i && l === j ? to! : point)));
      const weight = bernsteinAll(m, u)[i]! * bernsteinAll(n, v)[j]!;
      return [[sub(patchPoint(moved, u, v), patchPoint(net, u, v)), scale(sub(to!, net[i]![j]!), weight)]];
    },
  },
  "middle-of-patch": {
    formula: String.raw`S(\tfrac12, \tfrac12) = \frac{1}{64} \sum_{i=0}^{3} \sum_{j=0}^{3} \binom{3}{i} \binom{3}{j} c_{ij}`,
    sides: (draw) => {
      const net = Array.from({ length: 4 }, () => draw.points(4, 3));
      const row = indices(4).map((i) => binomial(3, i));
      return [[scale(doubleSum(net, row, row), 1 / 64), patchPoint(net, 0.5, 0.5)]];
    },
  },
  "patch-derivative": {
    formula: String.raw`S_u(u, v) = m \sum_{i=0}^{m-1} \sum_{j=0}^{n} (c_{i+1,j} - c_{ij}) B_i^{m-1}(u) B_j^n(v)`,
    sides: (draw) => {
      const { m, n, net, u, v } = patch(draw);
      const legs = net.slice(1).map((row, i) => row.map((point, j) => sub(point, net[i]![j]!)));
      const written = scale(doubleSum(legs, bernsteinAll(m - 1, u), bernsteinAll(n, v)), m);
      return [[written, patchPartial(net, u, v, 1, 0)]];
    },
  },
  "patch-corner": {
    formula: String.raw`S(0, 0) = c_{00}, \qquad S_u(0, 0) = m (c_{10} - c_{00}), \qquad S_v(0, 0) = n (c_{01} - c_{00})`,
    sides: (draw) => {
      const { m, n, net } = patch(draw);
      const corner = net[0]![0]!;
      return [
        [patchPoint(net, 0, 0), corner],
        [patchPartial(net, 0, 0, 1, 0), scale(sub(net[1]![0]!, corner), m)],
        [patchPartial(net, 0, 0, 0, 1), scale(sub(net[0]![1]!, corner), n)],
      ];
    },
  },
  "gaussian-curvature": {
    formula: String.raw`K = \frac{(S_{uu} \cdot n)(S_{vv} \cdot n) - (S_{uv} \cdot n)^2}{\norm{S_u \times S_v}^2}`,
    sides: (draw) => {
      const { net, u, v } = patch(draw, 2);
      const surface = bezierPatch(net);
      const { normal } = fundamentalForms(surface, u, v)!;
      const bend = (k: number, l: number) => dot(surface.partial(u, v, k, l), normal);
      const area = norm(cross(surface.partial(u, v, 1, 0), surface.partial(u, v, 0, 1)));
      const written = (bend(2, 0) * bend(0, 2) - bend(1, 1) ** 2) / area ** 2;
      return [[written, surfaceCurvature(surface, u, v)!.gaussian]];
    },
    tolerance: 1e-6,
  },
  "saddle-example": {
    formula: String.raw`\begin{aligned}
S(u, v) &= (u, v, uv) \\
S_u &= (1, 0, v), \qquad S_v = (0, 1, u) \\
S_u \times S_v &= (-v, -u, 1)
\end{aligned}`,
    sides: (draw) => {
      const [u, v] = [draw.number(0, 1), draw.number(0, 1)];
      const net = [
        [
          [0, 0, 0],
          [0, 1, 0],
        ],
        [
          [1, 0, 0],
          [1, 1, 1],
        ],
      ];
      const [su, sv] = [patchPartial(net, u, v, 1, 0), patchPartial(net, u, v, 0, 1)];
      return [
        [[u, v, u * v], patchPoint(net, u, v)],
        [[1, 0, v], su],
        [[0, 1, u], sv],
        [[-v, -u, 1], cross(su, sv)],
      ];
    },
  },
};
