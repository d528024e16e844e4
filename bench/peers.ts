/** What the benchmark uses of other libraries, which come without types or with far more of them. */
export type Peers = {
  readonly Bezier: new (coordinates: number[]) => { get(t: number): { x: number } };
  readonly three: typeof import("three");
  readonly verb: {
    geom: {
      NurbsSurface: {
        byKnotsControlPointsWeights(
          degreeU: number,
          degreeV: number,
          knotsU: number[],
          knotsV: number[],
          points: readonly (readonly (readonly number[])[])[],
        ): { point(u: number, v: number): number[]; normal(u: number, v: number): number[] };
      };
    };
  };
  readonly nurbs: (options: object) => { evaluate(out: number[], u: number, v: number): number[] };
};
