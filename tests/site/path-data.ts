export type Arc = readonly (readonly number[])[];

/** The cubic arcs of SVG path data that is made of one M and absolute C commands only. */
export function arcsOf(d: string): Arc[] {
  const [start, ...rest] = d
    .split("C")
    .map((part) => part.replace("M", "").trim().split(/[ ,]+/).map(Number));
  const arcs: Arc[] = [];
  let from: readonly number[] = start!;
  for (const numbers of rest) {
    for (let i = 0; i < numbers.length; i += 6) {
      const [a, b, c, d2, e, f] = numbers.slice(i, i + 6) as [number, number, number, number, number, number];
      arcs.push([from, [a, b], [c, d2], [e, f]]);
      from = [e, f];
    }
  }
  return arcs;
}

/** Second derivatives with respect to x at both ends of an arc whose x runs evenly: y is a function of x. */
export function secondDerivatives(arc: Arc): readonly [number, number] {
  const width = arc[3]![0]! - arc[0]![0]!;
  const bend = (i: number) => (6 * (arc[i]![1]! - 2 * arc[i + 1]![1]! + arc[i + 2]![1]!)) / width ** 2;
  return [bend(0), bend(1)];
}
