import { expect, test } from "vitest";
import {
  bezierCurve,
  type Curve,
  isRegular,
  norm,
  type Point,
  unitTangent,
  zeroSpeed,
} from "../../src/math/index.ts";
import { forAll, points, unit } from "./property.ts";

/** The same curve without its known speed. */
function bare(controlPoints: readonly Point[], domain?: readonly [number, number]): Curve {
  const { speed: _, ...curve } = bezierCurve(controlPoints, domain);
  return curve;
}

const cusp: Point[] = [
  [0, 0],
  [2, 2],
  [0, 2],
  [2, 0],
];

test("a regular point: the direction of the derivative", () => {
  const direction = unitTangent(
    bezierCurve([
      [0, 0],
      [3, 4],
    ]),
    0.2,
  )!;
  expect(direction[0]).toBeCloseTo(0.6, 15);
  expect(direction[1]).toBeCloseTo(0.8, 15);
  forAll([points(2, 6), unit], (b, t) => {
    const curve = bezierCurve(b);
    if (!isRegular(curve, t)) return;
    const tangent = unitTangent(curve, t)!;
    expect(norm(tangent)).toBeCloseTo(1, 12);
    const velocity = curve.derivative(t);
    tangent.forEach((x, axis) => {
      expect(x * norm(velocity)).toBeCloseTo(velocity[axis]!, 9);
    });
  });
});

test("where the derivative vanishes: the limit from one side", () => {
  for (const curve of [bezierCurve(cusp), bare(cusp)]) {
    expect(isRegular(curve, 0.5)).toBe(false);
    expect(isRegular(curve, 0.4)).toBe(true);
    const right = unitTangent(curve, 0.5)!;
    const left = unitTangent(curve, 0.5, "left")!;
    expect(right[0]).toBeCloseTo(0, 12);
    expect(right[1]).toBeCloseTo(-1, 12);
    expect(left[1]).toBeCloseTo(1, 12);
  }
});

test("repeated end control points: towards the first different one, by default from inside", () => {
  const ends = bezierCurve([
    [0, 0],
    [0, 0],
    [0, 2],
    [3, 2],
    [3, 2],
  ]);
  expect(unitTangent(ends, 0)).toEqual([0, 1]);
  expect(unitTangent(ends, 1)).toEqual([1, -0]);
  expect(unitTangent(ends, 1, "right")).toEqual([-1, 0]);
  const thrice = bezierCurve([
    [0, 0],
    [0, 0],
    [0, 0],
    [1, 0],
  ]);
  expect(unitTangent(thrice, 0)).toEqual([1, 0]);
  expect(unitTangent(thrice, 0, "left")).toEqual([1, 0]);
});

test("a point has no direction", () => {
  for (const curve of [
    bezierCurve([[1, 2]]),
    bezierCurve([
      [1, 2],
      [1, 2],
    ]),
    bare([
      [1, 2],
      [1, 2],
    ]),
  ]) {
    expect(unitTangent(curve, 0.5)).toBeNull();
    expect(isRegular(curve, 0.5)).toBe(false);
  }
});

test("derivatives that vanish up to rounding only, over a domain far from 0", () => {
  const decimals = cusp.map((p) => p.map((x) => 0.1 + 0.3 * x));
  for (const domain of [
    [0, 1],
    [1000, 1001],
  ] as const) {
    const middle = (domain[0] + domain[1]) / 2;
    for (const curve of [bezierCurve(decimals, domain), bare(decimals, domain)]) {
      expect(isRegular(curve, middle)).toBe(false);
      expect(unitTangent(curve, middle)![1]).toBeCloseTo(-1, 9);
      expect(unitTangent(curve, middle, "left")![1]).toBeCloseTo(1, 9);
    }
    // Slow, but not still: 1e-7 of the top speed is a direction.
    const slow: Point[] = [
      [0, 0],
      [1e-7, 0],
      [0, 1],
      [1, 1],
    ];
    for (const curve of [bezierCurve(slow, domain), bare(slow, domain)]) {
      expect(unitTangent(curve, domain[0])).toEqual([1, 0]);
    }
  }
});

test("the known speed decides where the first derivatives do not tell", () => {
  const still: Point[] = [...new Array<Point>(8).fill([1, 1]), [1, 3]];
  expect(unitTangent(bezierCurve(still), 0)).toEqual([0, 1]);
  const longer: Point[] = [...new Array<Point>(9).fill([1, 1]), [1, 3]];
  expect(unitTangent(bezierCurve(longer), 0)).toBeNull();
  const faint = bezierCurve([
    [0, 0],
    [1e-13, 0],
    [2e-13, 0],
    [3e-13, 0],
    [0, 1],
  ]);
  expect(isRegular(faint, 0)).toBe(false);
  expect(unitTangent(faint, 0)![1]).toBeCloseTo(1, 9);
});

test("what counts as zero depends neither on the size nor on the domain", () => {
  for (const factor of [1e-9, 1, 1e9]) {
    for (const domain of [
      [0, 1],
      [0, 1e-6],
      [0, 1e6],
    ] as const) {
      const scaled = cusp.map((p) => p.map((x) => factor * x));
      for (const curve of [bezierCurve(scaled, domain), bare(scaled, domain)]) {
        expect(isRegular(curve, domain[1] / 2)).toBe(false);
        expect(isRegular(curve, domain[1] * 0.49)).toBe(true);
        expect(unitTangent(curve, domain[1] / 2)![1]).toBeCloseTo(-1, 9);
      }
    }
  }
  expect(
    zeroSpeed(
      bezierCurve([
        [0, 0],
        [3, 4],
      ]),
      0,
    ),
  ).toBeCloseTo(5e-10, 20);
  expect(
    zeroSpeed(
      bare([
        [0, 0],
        [3, 4],
      ]),
      0,
    ),
  ).toBeCloseTo(5e-10, 20);
  // ‖p″‖ = 6 · ‖b_2 − 2b_1 + b_0‖ over the domain's length, ‖p‴‖ over its square.
  expect(zeroSpeed(bare([[0], [0], [1], [9]], [0, 2]), 0)).toBeCloseTo(18e-10, 20);
});
