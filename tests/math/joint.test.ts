import { describe, expect, test } from "vitest";
import {
  bezierCurve,
  classifyJoint,
  type Joint,
  type Point,
  rationalBezierCurve,
  splitBezier,
} from "../../src/math/index.ts";
import { forAll, points, unit } from "./property.ts";

const a: Point[] = [
  [0, 0],
  [1, 2],
  [3, 3],
  [4, 1],
];
const classify = (b: Point[]): Joint => classifyJoint(bezierCurve(a), bezierCurve(b));

/** The classes that hold, as a list. */
function classes(joint: Joint): string[] {
  return (["C0", "C1", "C2", "G0", "G1", "G2"] as const).filter((name) => joint[name] === true);
}

describe("classifyJoint", () => {
  test("from nothing to everything", () => {
    expect(
      classes(
        classify([
          [5, 1],
          [6, 0],
          [7, 0],
          [8, 0],
        ]),
      ),
    ).toEqual([]);
    expect(
      classes(
        classify([
          [4, 1],
          [6, 2],
          [5, -6],
          [2, -16],
        ]),
      ),
    ).toEqual(["C0", "G0"]);
    expect(
      classes(
        classify([
          [4, 1],
          [4.5, 0],
          [7, -5],
          [2, -16],
        ]),
      ),
    ).toEqual(["C0", "G0", "G1"]);
    expect(
      classes(
        classify([
          [4, 1],
          [5, -1],
          [7, -5],
          [2, -16],
        ]),
      ),
    ).toEqual(["C0", "C1", "G0", "G1"]);
    expect(
      classes(
        classify([
          [4, 1],
          [6, -3],
          [4, -19],
          [-18, -63],
        ]),
      ),
    ).toEqual(["C0", "G0", "G1", "G2"]);
    expect(
      classes(
        classify([
          [4, 1],
          [5, -1],
          [5, -6],
          [2, -16],
        ]),
      ),
    ).toEqual(["C0", "C1", "C2", "G0", "G1", "G2"]);
  });

  test("the numbers behind the verdict", () => {
    const joint = classify([
      [4, 1],
      [6, -3],
      [4, -19],
      [-18, -63],
    ]);
    expect(joint.positionGap).toBe(0);
    expect(joint.d1Gap).toBeCloseTo(Math.hypot(3, 6), 12);
    expect(joint.tangentAngle).toBeCloseTo(0, 12);
    expect(joint.curvatureGap).toBeCloseTo(0, 12);
    expect(joint.factor).toBeCloseTo(2, 12);
    expect(joint.regular).toBe(true);
    const corner = classify([
      [4, 1],
      [6, 2],
      [5, -6],
      [2, -16],
    ]);
    expect(corner.tangentAngle).toBeCloseTo(Math.PI / 2, 12);
    expect(corner.factor).toBeNull();
  });

  test("equal derivatives across a gap are no continuity", () => {
    const joint = classify([
      [4.25, 1],
      [5.25, -1],
      [5.25, -6],
      [2.25, -16],
    ]);
    expect(classes(joint)).toEqual([]);
    expect([joint.positionGap, joint.d1Gap, joint.d2Gap]).toEqual([0.25, 0, 0]);
    expect([joint.G1, joint.G2]).toEqual([false, false]);
  });

  test("the opposite direction is not G¹", () => {
    expect(
      classify([
        [4, 1],
        [3, 3],
        [5, -6],
        [2, -16],
      ]),
    ).toMatchObject({ G1: false, G2: false, regular: true });
  });

  test("with zero derivatives even C² does not imply G¹, and G² is not tested", () => {
    const stop: Point[] = [
      [0, 0],
      [1, 2],
      [4, 1],
      [4, 1],
    ];
    const cusp = classifyJoint(
      bezierCurve(stop),
      bezierCurve([
        [4, 1],
        [4, 1],
        [1, 2],
        [5, 4],
      ]),
    );
    expect(cusp).toMatchObject({
      C2: true,
      G1: false,
      G2: false,
      regular: false,
      curvatureGap: null,
      factor: null,
    });
    const smooth = classifyJoint(
      bezierCurve(stop),
      bezierCurve([
        [4, 1],
        [4, 1],
        [5.5, 0.5],
        [5, 4],
      ]),
    );
    expect(smooth).toMatchObject({ C1: true, C2: false, G1: true, G2: null, regular: false, factor: null });
    const left = classifyJoint(
      bezierCurve(stop),
      bezierCurve([
        [4, 1],
        [4.75, 0.75],
        [5, 4],
        [6, 7],
      ]),
    );
    expect(left).toMatchObject({ C1: false, G1: true, G2: null, regular: false, curvatureGap: null });
    const still = classifyJoint(
      bezierCurve(a),
      bezierCurve([
        [4, 1],
        [4, 1],
      ]),
    );
    expect(still).toMatchObject({ G1: false, G2: false, tangentAngle: null, regular: false });
  });

  test("the domains count for C, not for G", () => {
    const [left, right] = splitBezier(a, 0.25);
    const first = bezierCurve(left, [0, 0.25]);
    const matching = classifyJoint(first, bezierCurve(right, [0, 0.75]));
    expect(classes(matching)).toEqual(["C0", "C1", "C2", "G0", "G1", "G2"]);
    const faster = classifyJoint(first, bezierCurve(right, [0, 0.5]));
    expect(classes(faster)).toEqual(["C0", "G0", "G1", "G2"]);
    expect(faster.factor).toBeCloseTo(1.5, 12);
  });

  test("curves of different kinds: two quarters of a circle", () => {
    const w = [1, Math.SQRT1_2, 1];
    const first = rationalBezierCurve(
      [
        [1, 0],
        [1, 1],
        [0, 1],
      ],
      w,
    );
    const second = rationalBezierCurve(
      [
        [0, 1],
        [-1, 1],
        [-1, 0],
      ],
      w,
    );
    expect(classes(classifyJoint(first, second))).toEqual(["C0", "C1", "G0", "G1", "G2"]);
  });

  test("neither the size nor the place of the curves matters", () => {
    const b: Point[] = [
      [4, 1],
      [5, -1],
      [7, -5],
      [2, -16],
    ];
    for (const factor of [1e-8, 1e8]) {
      for (const shift of [0, 1000 * factor]) {
        const move = (p: Point): Point => p.map((x) => factor * x + shift);
        const joint = classifyJoint(bezierCurve(a.map(move)), bezierCurve(b.map(move)));
        expect(classes(joint)).toEqual(["C0", "C1", "G0", "G1"]);
      }
    }
  });

  test("what counts as equal is a part of the curves' size over their own domain, and the coordinates' rounding", () => {
    const over = (points: Point[]) => bezierCurve(points, [1000, 1001]);
    const apart = a.map((p) => [p[0]! + 4.000004, p[1]! + 1]);
    expect(classifyJoint(over(a), over(apart)).C0).toBe(false);
    // Two neighbouring doubles, far away: a tiny curve cannot be closed better.
    const far = (p: Point): Point => p.map((x) => 1e6 + 1e-3 * x);
    const next = [
      [4, 1],
      [5, -1],
    ].map(far);
    next[0] = [next[0]![0]! + 2 ** -33, next[0]![1]!];
    expect(classifyJoint(bezierCurve(a.map(far)), bezierCurve(next)).C0).toBe(true);
    expect(classifyJoint(bezierCurve(next).split!(0.5)[0], bezierCurve(next)).C0).toBe(false);
    const atOrigin = bezierCurve(a.map((p) => [p[0]! - 4, p[1]! - 1]));
    for (const leg of [1e-9, 1e9]) {
      const b: Point[] = [
        [0, 0],
        [leg, -2 * leg],
      ];
      expect(classifyJoint(atOrigin, bezierCurve(b))).toMatchObject({
        C0: true,
        C1: false,
        G1: true,
        G2: false,
      });
    }
  });

  test("a small curvature beside a straight piece is a difference", () => {
    const bent: Point[] = [
      [0, 0],
      [1, 0],
      [2, 1e-4],
    ];
    const joint = classifyJoint(
      bezierCurve([
        [-1, 0],
        [0, 0],
      ]),
      bezierCurve(bent),
    );
    expect(joint).toMatchObject({ G1: true, G2: false });
    expect(joint.curvatureGap).toBeCloseTo(0.5e-4, 12);
    expect(
      classifyJoint(
        bezierCurve([
          [-1, 0],
          [0, 0],
        ]),
        bezierCurve([
          [0, 0],
          [3, 0],
        ]),
      ).G2,
    ).toBe(true);
  });

  test("the tolerance decides", () => {
    const near: Point[] = [
      [4, 1.0001],
      [5, -0.9999],
      [5, -6],
      [2, -16],
    ];
    const [strict, loose] = [1e-9, 1e-2].map((e) => classifyJoint(bezierCurve(a), bezierCurve(near), e));
    expect(classes(strict!)).toEqual([]);
    expect(classes(loose!)).toEqual(["C0", "C1", "C2", "G0", "G1", "G2"]);
    const turned: Point[] = [
      [4, 1],
      [5, -1.01],
      [5, -6],
      [2, -16],
    ];
    expect(classifyJoint(bezierCurve(a), bezierCurve(turned), 1e-3).G1).toBe(false);
    expect(classifyJoint(bezierCurve(a), bezierCurve(turned), 1e-1).G1).toBe(true);
  });

  test("bad arguments are named", () => {
    expect(() => classifyJoint(bezierCurve(a), bezierCurve([[4, 1, 0]]))).toThrow(
      "b: expected a curve in 2 dimensions as a, got 3",
    );
    expect(() => classifyJoint(bezierCurve(a), bezierCurve(a), 0)).toThrow(/^tolerance: /);
  });

  test("a split curve is C² at the joint", () => {
    const inside = unit.map((t) => 0.1 + 0.8 * t);
    forAll([points(2, 6), inside], (b, t) => {
      const [left, right] = bezierCurve(b).split!(t);
      const joint = classifyJoint(left, right, 1e-7);
      expect([joint.C0, joint.C1, joint.C2]).toEqual([true, true, true]);
      if (joint.regular) expect(joint.G1).toBe(true);
    });
  });
});
