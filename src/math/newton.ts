import { checkDistinct, checkNumber, checkPoints, checkSameLength } from "./check.ts";
import { add, type Point, scale, sub, zero } from "./point.ts";

/**
 * The table of divided differences: row r holds f[t_i, …, t_{i+r}] for i = 0 … n − r.
 *
 * Row 0 is the data; f[t_i … t_{i+r}] = (f[t_{i+1} … t_{i+r}] − f[t_i … t_{i+r−1}])/(t_{i+r} − t_i). The nodes need not
 * be sorted. A new node at the end adds one entry to each row and changes none.
 *
 * @throws RangeError if there is no node, two nodes are equal, the lists do not fit or a number is not finite.
 */
export function dividedDifferenceTable(nodes: readonly number[], points: readonly Point[]): Point[][] {
  checkData(nodes, points);
  const table: Point[][] = [[...points]];
  for (let r = 1; r < nodes.length; r++) {
    const f = table[r - 1]!;
    table.push(
      f.slice(1).map((next, i) => {
        const width = nodes[i + r]! - nodes[i]!;
        return sub(next, f[i]!).map((difference) => difference / width);
      }),
    );
  }
  return table;
}

/**
 * Newton's coefficients f[t_0], f[t_0, t_1], …, f[t_0, …, t_n] in the given order of the nodes.
 *
 * @throws RangeError as `dividedDifferenceTable`.
 */
export function dividedDifferences(nodes: readonly number[], points: readonly Point[]): Point[] {
  return dividedDifferenceTable(nodes, points).map((row) => row[0]!);
}

/**
 * The value at t of Newton's form Σ c_i · Π_{j<i} (t − t_j), from the inside out (Horner).
 *
 * Cheap to extend, but with many ascending nodes less accurate than the barycentric form: from about degree 14 on
 * Chebyshev nodes, 20 on equidistant ones.
 *
 * @throws RangeError if there is no coefficient, nodes are missing or a number is not finite.
 */
export function newtonPoint(nodes: readonly number[], coefficients: readonly Point[], t: number): Point {
  checkPoints("coefficients", coefficients);
  checkSameLength("nodes", nodes, "coefficients", coefficients);
  checkNumber("t", t);
  let value = coefficients.at(-1)!;
  for (let i = coefficients.length - 2; i >= 0; i--) {
    value = add(scale(value, t - nodes[i]!), coefficients[i]!);
  }
  return value;
}

/**
 * The monomial coefficients a_0, a_1, …, a_n (ascending) of the interpolating polynomial.
 *
 * Newton's form multiplied out. Ill-conditioned for high degrees: for looking at, not for evaluating.
 *
 * @throws RangeError as `dividedDifferenceTable`.
 */
export function monomialCoefficients(nodes: readonly number[], points: readonly Point[]): Point[] {
  const c = dividedDifferences(nodes, points);
  const origin = zero(points[0]!.length);
  let a: Point[] = [];
  for (let i = c.length - 1; i >= 0; i--) {
    // (t − t_i) · a(t) + c_i
    const shifted = [c[i]!, ...a];
    a = shifted.map((power, k) => sub(power, scale(a[k] ?? origin, nodes[i]!)));
  }
  return a;
}

function checkData(nodes: readonly number[], points: readonly Point[]): void {
  checkDistinct("nodes", nodes);
  checkPoints("points", points);
  checkSameLength("points", points, "nodes", nodes);
}
