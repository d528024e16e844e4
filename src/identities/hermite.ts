import {
  add,
  applyToGeometry,
  basisMatrix,
  bernstein,
  binomial,
  combine,
  hermiteBasis,
  hermiteCoefficientMatrix,
  hermiteCoefficients,
  hermiteCubicBasis,
  hermiteCurve,
  hermiteMatrix,
  hermitePoint,
  hermiteToBezier,
  multiply4,
  type Point,
  scale,
  sub,
} from "../math/index.ts";
import { type Draw, type Identity, sum } from "./identity.ts";

type Four = readonly [Point, Point, Point, Point];

/** Random data p₀, m₀, m₁, p₁ of a segment, and a parameter. */
function segment(draw: Draw): { data: Four; t: number } {
  return { data: draw.points(4) as unknown as Four, t: draw.number(0, 1) };
}

/** An interval that is neither tiny nor far away, a parameter inside, and an order. */
function interval(draw: Draw): { t0: number; t1: number; t: number; m: number } {
  const t0 = draw.number(-2, 2);
  const t1 = t0 + draw.number(0.5, 2);
  return { t0, t1, t: draw.number(t0, t1), m: draw.integer(0, 5) };
}

const delta = (a: number, b: number) => (a === b ? 1 : 0);
const factorial = (k: number): number => (k < 2 ? 1 : k * factorial(k - 1));

/** H_{0,k} of [0, 1] as the closed form says. */
const closed = (m: number, k: number, t: number) =>
  (t ** k / factorial(k)) * (1 - t) ** (m + 1) * sum(0, m - k, (j) => binomial(m + j, j) * t ** j);

/** The formulas of the lesson on Hermite curves. */
export const hermite: Readonly<Record<string, Identity>> = {
  "hermite-segment": {
    formula: "p(t) = H_0^3(t) p_0 + H_1^3(t) m_0 + H_2^3(t) m_1 + H_3^3(t) p_1",
    sides: (draw) => {
      const { data, t } = segment(draw);
      return [[combine(hermiteCubicBasis(t), data), hermitePoint(...data, t)]];
    },
  },
  "hermite-cubics": {
    formula: String.raw`\begin{aligned}
H_0^3(t) &= (1-t)^2 (1+2t), & H_1^3(t) &= t (1-t)^2, \\
H_3^3(t) &= t^2 (3-2t), & H_2^3(t) &= -t^2 (1-t)
\end{aligned}`,
    sides: (draw) => {
      const t = draw.number(0, 1);
      const s = 1 - t;
      const written = [s ** 2 * (1 + 2 * t), t * s ** 2, -(t ** 2) * s, t ** 2 * (3 - 2 * t)];
      const [[h0, h1], [h3, h2]] = hermiteBasis(1, 0, 1, t);
      return [[written, [h0!, h1!, h2!, h3!]]];
    },
  },
  "hermite-sum": {
    formula: String.raw`\begin{aligned}
p(t) &= \bigl(H_0^3(t) p_0 + H_3^3(t) p_1\bigr) + H_1^3(t) m_0 + H_2^3(t) m_1, \\
1 &= H_0^3(t) + H_3^3(t)
\end{aligned}`,
    sides: (draw) => {
      const { data, t } = segment(draw);
      const [h0, h1, h2, h3] = hermiteCubicBasis(t);
      const [p0, m0, m1, p1] = data;
      const onChord = combine([h0, h3], [p0, p1]);
      return [
        [add(onChord, combine([h1, h2], [m0, m1])), hermitePoint(...data, t)],
        [h0 + h3, 1],
      ];
    },
  },
  "hermite-tangent-changed": {
    formula: String.raw`\tilde p(t) - p(t) = H_1^3(t) \bigl(\tilde m_0 - m_0\bigr)`,
    sides: (draw) => {
      const { data, t } = segment(draw);
      const [p0, m0, m1, p1] = data;
      const other = draw.points(1)[0]!;
      const moved = sub(hermitePoint(p0, other, m1, p1, t), hermitePoint(...data, t));
      return [[moved, scale(sub(other, m0), hermiteCubicBasis(t)[1])]];
    },
  },
  "hermite-affine": {
    formula: String.raw`\begin{aligned}
A p(t) + b = {} & H_0^3(t) (A p_0 + b) + H_1^3(t) A m_0 \\
& + H_2^3(t) A m_1 + H_3^3(t) (A p_1 + b)
\end{aligned}`,
    sides: (draw) => {
      const { data, t } = segment(draw);
      const [first, second, b] = draw.points(3);
      const A = ([x, y]: Point): Point => [
        first![0]! * x! + first![1]! * y!,
        second![0]! * x! + second![1]! * y!,
      ];
      const [p0, m0, m1, p1] = data.map(A) as unknown as Four;
      const image = hermitePoint(add(p0, b!), m0, m1, add(p1, b!), t);
      return [[add(A(hermitePoint(...data, t)), b!), image]];
    },
  },
  "hermite-to-bezier": {
    formula: String.raw`m_0 = 3 (c_1 - c_0), \qquad m_1 = 3 (c_3 - c_2)`,
    sides: (draw) => {
      const { data, t } = segment(draw);
      const c = hermiteToBezier(...data);
      return [
        [data[1], scale(sub(c[1], c[0]), 3)],
        [data[2], scale(sub(c[3], c[2]), 3)],
        [
          combine(
            [0, 1, 2, 3].map((i) => bernstein(3, i, t)),
            c,
          ),
          hermitePoint(...data, t),
        ],
      ];
    },
  },
  "hermite-from-bernstein": {
    formula: String.raw`H_0^3 = B_0^3 + B_1^3, \qquad H_1^3 = \tfrac13 B_1^3, \qquad H_2^3 = -\tfrac13 B_2^3, \qquad H_3^3 = B_2^3 + B_3^3`,
    sides: (draw) => {
      const t = draw.number(0, 1);
      const [b0, b1, b2, b3] = [0, 1, 2, 3].map((i) => bernstein(3, i, t));
      return [[hermiteCubicBasis(t), [b0! + b1!, b1! / 3, -b2! / 3, b2! + b3!]]];
    },
  },
  "hermite-substitutions": {
    formula: String.raw`\begin{pmatrix} p_0 \\ p_1 \\ m_0 \\ m_1 \end{pmatrix} =
\begin{pmatrix} t_0^3 & t_0^2 & t_0 & 1 \\ t_1^3 & t_1^2 & t_1 & 1 \\ 3t_0^2 & 2t_0 & 1 & 0 \\ 3t_1^2 & 2t_1 & 1 & 0 \end{pmatrix}
\begin{pmatrix} a_3 \\ a_2 \\ a_1 \\ a_0 \end{pmatrix}`,
    sides: (draw) => {
      const { t0, t1 } = interval(draw);
      const [p0, p1, m0, m1] = draw.points(4) as unknown as Four;
      const a = hermiteCoefficientMatrix(t0, t1, [p0, p1, m0, m1]);
      const written = [t0, t1].map((s) => [s ** 3, s ** 2, s, 1] as const);
      const slopes = [t0, t1].map((s) => [3 * s ** 2, 2 * s, 1, 0] as const);
      const K = [...written, ...slopes] as unknown as Parameters<typeof applyToGeometry>[0];
      return [
        [K, hermiteMatrix(t0, t1).K],
        [applyToGeometry(K, a), [p0, p1, m0, m1]],
      ];
    },
    tolerance: 1e-8,
  },
  "hermite-determinant": {
    formula: String.raw`\det K = -(t_1 - t_0)^4`,
    sides: (draw) => {
      const { t0, t1 } = interval(draw);
      return [[determinant(hermiteMatrix(t0, t1).K), -((t1 - t0) ** 4)]];
    },
  },
  "hermite-inverse": {
    formula: String.raw`K = \begin{pmatrix} 0 & 0 & 0 & 1 \\ 1 & 1 & 1 & 1 \\ 0 & 0 & 1 & 0 \\ 3 & 2 & 1 & 0 \end{pmatrix}, \qquad
K^{-1} = \begin{pmatrix} 2 & -2 & 1 & 1 \\ -3 & 3 & -2 & -1 \\ 0 & 0 & 1 & 0 \\ 1 & 0 & 0 & 0 \end{pmatrix}`,
    sides: () => {
      const { K, Kinv } = hermiteMatrix(0, 1);
      const written = [
        [2, -2, 1, 1],
        [-3, 3, -2, -1],
        [0, 0, 1, 0],
        [1, 0, 0, 0],
      ];
      const rows = [
        [0, 0, 0, 1],
        [1, 1, 1, 1],
        [0, 0, 1, 0],
        [3, 2, 1, 0],
      ];
      const unit = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((j) => delta(i, j)));
      return [
        [rows, K],
        [written, Kinv],
        [multiply4(K, Kinv), unit],
        [written, basisMatrix("hermitePointsFirst")],
      ];
    },
  },
  "hermite-coefficients": {
    formula: String.raw`\begin{aligned}
a_3 &= 2 (p_0 - p_1) + m_0 + m_1, & a_1 &= m_0, \\
a_2 &= 3 (p_1 - p_0) - 2 m_0 - m_1, & a_0 &= p_0
\end{aligned}`,
    sides: (draw) => {
      const { data, t } = segment(draw);
      const [p0, m0, m1, p1] = data;
      const a3 = add(scale(sub(p0, p1), 2), add(m0, m1));
      const a2 = sub(scale(sub(p1, p0), 3), add(scale(m0, 2), m1));
      return [
        [[a3, a2, m0, p0], hermiteCoefficients(...data)],
        [combine([t ** 3, t ** 2, t, 1], [a3, a2, m0, p0]), hermitePoint(...data, t)],
      ];
    },
  },
  "hermite-orders": {
    formula: String.raw`\begin{pmatrix} 2 & -2 & 1 & 1 \\ -3 & 3 & -2 & -1 \\ 0 & 0 & 1 & 0 \\ 1 & 0 & 0 & 0 \end{pmatrix}
\begin{pmatrix} p_0 \\ p_1 \\ m_0 \\ m_1 \end{pmatrix} =
\begin{pmatrix} 2 & 1 & 1 & -2 \\ -3 & -2 & -1 & 3 \\ 0 & 1 & 0 & 0 \\ 1 & 0 & 0 & 0 \end{pmatrix}
\begin{pmatrix} p_0 \\ m_0 \\ m_1 \\ p_1 \end{pmatrix}`,
    sides: (draw) => {
      const [p0, m0, m1, p1] = segment(draw).data;
      const first = basisMatrix("hermitePointsFirst");
      const second = basisMatrix("hermite");
      const written = [
        [2, 1, 1, -2],
        [-3, -2, -1, 3],
        [0, 1, 0, 0],
        [1, 0, 0, 0],
      ];
      return [
        [written, second],
        [applyToGeometry(first, [p0, p1, m0, m1]), applyToGeometry(second, [p0, m0, m1, p1])],
      ];
    },
  },
  "hermite-problem": {
    formula: String.raw`Q(t) = \sum_{i=0}^1 \sum_{k=0}^m P_i^{(k)} H_{i,k}(t), \qquad t_0 \le t \le t_1`,
    sides: (draw) => {
      const { t0, t1, t, m } = interval(draw);
      const [start, end] = [draw.points(m + 1), draw.points(m + 1)];
      const [first, last] = hermiteBasis(m, t0, t1, t);
      return [[combine([...first, ...last], [...start, ...end]), hermiteCurve(t0, t1, start, end).point(t)]];
    },
  },
  "hermite-delta": {
    formula: String.raw`\frac{\mathrm{d}^r}{\mathrm{d}t^r} H_{i,k}(t) \Big|_{t = t_j} = \delta_{ij} \delta_{kr}`,
    sides: (draw) => {
      const { t0, t1, m } = interval(draw);
      const [i, j] = [draw.integer(0, 1), draw.integer(0, 1)];
      const [k, r] = [draw.integer(0, m), draw.integer(0, m)];
      const found = hermiteBasis(m, t0, t1, j === 0 ? t0 : t1, r)[i as 0 | 1][k]!;
      return [[found, delta(i, j) * delta(k, r)]];
    },
    tolerance: 1e-7,
  },
  "hermite-closed": {
    formula: String.raw`\begin{aligned}
H_{0,k}(t) &= \frac{t^k}{k!} (1-t)^{m+1} \sum_{j=0}^{m-k} \binom{m+j}{j} t^j, \\
H_{1,k}(t) &= (-1)^k H_{0,k}(1-t)
\end{aligned}`,
    sides: (draw) => {
      const [m, t] = [draw.integer(0, 5), draw.number(0, 1)];
      const k = draw.integer(0, m);
      const [first, last] = hermiteBasis(m, 0, 1, t);
      return [
        [closed(m, k, t), first[k]!],
        [(-1) ** k * closed(m, k, 1 - t), last[k]!],
      ];
    },
  },
  "hermite-interval": {
    formula: String.raw`H_{i,k}(t) = h^k \hat H_{i,k}(u), \qquad u = \frac{t - t_0}{h}, \qquad h = t_1 - t_0`,
    sides: (draw) => {
      const { t0, t1, t, m } = interval(draw);
      const h = t1 - t0;
      const [here, there] = [hermiteBasis(m, t0, t1, t), hermiteBasis(m, 0, 1, (t - t0) / h)];
      return [[here, there.map((row) => row.map((value, k) => h ** k * value))]];
    },
  },
  "hermite-quintic": {
    formula: String.raw`\begin{aligned}
H_{0,0}(t) &= (1-t)^3 (1 + 3t + 6t^2), \\
H_{0,1}(t) &= t (1-t)^3 (1 + 3t), \\
H_{0,2}(t) &= \tfrac12 t^2 (1-t)^3
\end{aligned}`,
    sides: (draw) => {
      const t = draw.number(0, 1);
      const s = (1 - t) ** 3;
      const written = [s * (1 + 3 * t + 6 * t ** 2), t * s * (1 + 3 * t), (t ** 2 * s) / 2];
      return [[written, hermiteBasis(2, 0, 1, t)[0]]];
    },
  },
  "hermite-example": {
    formula: String.raw`p(t) = \bigl(t + 2t^2 - 2t^3, 3t^2 - 2t^3\bigr)`,
    sides: (draw) => {
      const t = draw.number(0, 1);
      const written = [t + 2 * t ** 2 - 2 * t ** 3, 3 * t ** 2 - 2 * t ** 3];
      return [[written, hermitePoint([0, 0], [1, 0], [-1, 0], [1, 1], t)]];
    },
  },
};

/** By expansion along the first row. */
function determinant(rows: readonly (readonly number[])[]): number {
  if (rows.length === 1) return rows[0]![0]!;
  const [first, ...rest] = rows;
  return sum(0, first!.length - 1, (k) => {
    const minor = rest.map((row) => row.filter((_, column) => column !== k));
    return (-1) ** k * first![k]! * determinant(minor);
  });
}
