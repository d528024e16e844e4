import fc from "fast-check";
import { describe, expect, test } from "vitest";
import {
  bezierCurve,
  classifyJoint,
  type Joint,
  type Point,
  repairJoint,
  sub,
} from "../../src/math/index.ts";
import { forAll, points, size } from "./property.ts";

const a: Point[] = [
  [0, 0],
  [1, 2],
  [3, 3],
  [4, 1],
];
const classify = (b: Point[]): Joint => classifyJoint(bezierCurve(a), bezierCurve(b));

describe("repairJoint", () => {
  const b: Point[] = [
    [4.5, 1.5],
    [6, 2],
    [5, -6],
    [2, -16],
  ];

  test("reaches what it is asked for, and changes no other point", () => {
    const fixed = { C0: 1, G1: 2, C1: 2, G2: 3, C2: 3 } as const;
    for (const to of ["C0", "G1", "C1", "G2", "C2"] as const) {
      const repaired = repairJoint(a, b, to)!;
      expect(classify(repaired)[to]).toBe(true);
      expect(repaired).toHaveLength(4);
      expect(repaired.slice(fixed[to])).toEqual(b.slice(fixed[to]));
      expect(repaired[0]).toEqual([4, 1]);
    }
  });

  test("as little as possible: G¹ keeps the leg's length, G² the place along the tangent", () => {
    const g1 = repairJoint(
      a,
      [
        [4, 1],
        [4, 6],
        [5, -6],
        [2, -16],
      ],
      "G1",
    )!;
    expect(Math.hypot(g1[1]![0]! - 4, g1[1]![1]! - 1)).toBeCloseTo(5, 12);
    expect(classify(g1).C1).toBe(false);
    const g2 = repairJoint(
      a,
      [
        [4, 1],
        [4, 6],
        [5, -6],
        [2, -16],
      ],
      "G2",
    )!;
    const direction: Point = [1 / Math.sqrt(5), -2 / Math.sqrt(5)];
    const along = (p: Point): number => (p[0]! - 4) * direction[0]! + (p[1]! - 1) * direction[1]!;
    expect(along(g2[2]!)).toBeCloseTo(along([5, -6]), 12);
    expect(classify(g2).C2).toBe(false);
  });

  test("by hand: C¹ and C² between cubics, C¹ from a cubic to a line", () => {
    expect(repairJoint(a, b, "C1")).toEqual([
      [4, 1],
      [5, -1],
      [5, -6],
      [2, -16],
    ]);
    expect(repairJoint(a, b, "C2")).toEqual([
      [4, 1],
      [5, -1],
      [5, -6],
      [2, -16],
    ]);
    expect(
      repairJoint(
        a,
        [
          [0, 0],
          [0, 0],
        ],
        "C1",
      ),
    ).toEqual([
      [4, 1],
      [7, -5],
    ]);
    expect(
      repairJoint(
        a,
        [
          [0, 0],
          [0, 0],
          [9, 9],
        ],
        "C1",
      ),
    ).toEqual([
      [4, 1],
      [5.5, -2],
      [9, 9],
    ]);
  });

  test("a leg of length 0 takes the length of a's last leg", () => {
    const g1 = repairJoint(
      a,
      [
        [4, 1],
        [4, 1],
        [5, -6],
        [2, -16],
      ],
      "G1",
    )!;
    expect(g1[1]![0]).toBeCloseTo(5, 12);
    expect(g1[1]![1]).toBeCloseTo(-1, 12);
    const stop: Point[] = [
      [0, 0],
      [1, 1],
      [4, 1],
      [4, 1],
    ];
    const limit = repairJoint(
      stop,
      [
        [4, 1],
        [4, 1],
        [5, 4],
        [6, 7],
      ],
      "G1",
    )!;
    expect(limit[1]![0]).toBeCloseTo(7, 12);
    expect(limit[1]![1]).toBeCloseTo(1, 12);
    expect(classifyJoint(bezierCurve(stop), bezierCurve(limit)).G1).toBe(true);
  });

  test("what cannot be done is null", () => {
    const point: Point[] = [
      [4, 1],
      [4, 1],
    ];
    for (const to of ["G1", "C1", "G2", "C2"] as const) expect(repairJoint(point, b, to)).toBeNull();
    expect(repairJoint(point, b, "C0")).not.toBeNull();
    const stop: Point[] = [
      [0, 0],
      [1, 1],
      [4, 1],
      [4, 1],
    ];
    for (const to of ["C1", "G2", "C2"] as const) expect(repairJoint(stop, b, to)).toBeNull();
    expect(repairJoint(a, [[1, 1]], "C0")).toEqual([[4, 1]]);
    for (const to of ["G1", "C1"] as const) expect(repairJoint(a, [[1, 1]], to)).toBeNull();
    for (const to of ["G2", "C2"] as const)
      expect(
        repairJoint(
          a,
          [
            [1, 1],
            [2, 2],
          ],
          to,
        ),
      ).toBeNull();
    expect(
      repairJoint(
        a,
        [
          [1, 1],
          [2, 2],
        ],
        "G1",
      ),
    ).not.toBeNull();
  });

  test("reaches its class for all curves it takes", () => {
    const kinds = fc.constantFrom("G1", "C1", "G2", "C2");
    forAll([points(4, 5, 3), points(4, 5, 3), kinds], (p, q, to) => {
      const leg = sub(p.at(-1)!, p.at(-2)!);
      fc.pre(Math.hypot(...leg) > 0.05 * size(p) && Math.hypot(...sub(q[1]!, q[0]!)) > 0.05 * size(q));
      const repaired = repairJoint(p, q, to as "G1")!;
      const joint = classifyJoint(bezierCurve(p), bezierCurve(repaired), 1e-7);
      expect(joint[to as "G1"]).toBe(true);
      expect(joint.regular).toBe(true);
    });
  });

  test("bad control points are named", () => {
    expect(() => repairJoint([], b, "C0")).toThrow(/^a: expected at least 1 point/);
    expect(() => repairJoint(a, [[1, 2, 3]], "C0")).toThrow(/^b\[0\]: expected 2 coordinates/);
  });
});
