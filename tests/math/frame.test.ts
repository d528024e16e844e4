import fc from "fast-check";
import { expect, test } from "vitest";
import {
  angleBetween,
  bezierCurve,
  type Curve,
  cross,
  distance,
  dot,
  type Frame,
  frenetFrame,
  norm,
  planeFrame,
  rotationMinimisingFrames,
} from "../../src/math/index.ts";
import { forAll, points, unit } from "./property.ts";

const space = bezierCurve([
  [0, 0, 0],
  [1, 2, 0],
  [3, 2, 1],
  [4, 0, 3],
]);

/** A helix of radius 3 that climbs by 4 per radian: κ = 3/25, τ = 4/25, speed 5. */
const helix: Curve = {
  dimension: 3,
  domain: [0, 10],
  point: (t) => [3 * Math.cos(t), 3 * Math.sin(t), 4 * t],
  derivative: (t, r = 1) => {
    const turn = t + (r * Math.PI) / 2;
    return [3 * Math.cos(turn), 3 * Math.sin(turn), r === 1 ? 4 : r === 0 ? 4 * t : 0];
  },
};

function expectOrthonormal({ tangent, normal, binormal }: Frame): void {
  for (const vector of [tangent, normal, binormal]) expect(norm(vector)).toBeCloseTo(1, 9);
  expect(Math.abs(dot(tangent, normal))).toBeLessThan(1e-9);
  expect(distance(cross(tangent, normal), binormal)).toBeLessThan(1e-9);
}

test("the Frenet frame of a helix: the normal points to its axis", () => {
  for (const t of [0, 1, 4.5]) {
    const frame = frenetFrame(helix, t)!;
    expectOrthonormal(frame);
    expect(frame.point).toEqual(helix.point(t));
    expect(distance(frame.normal, [-Math.cos(t), -Math.sin(t), 0])).toBeLessThan(1e-12);
    expect(frame.tangent[2]).toBeCloseTo(0.8, 12);
  }
});

test("no Frenet frame on a line, at a flat point or where the curve stops", () => {
  expect(
    frenetFrame(
      bezierCurve([
        [0, 0, 0],
        [0.1, 0.1, 0.1],
        [0.2, 0.2, 0.2],
        [0.7, 0.7, 0.7],
      ]),
      0.3,
    ),
  ).toBeNull();
  expect(
    frenetFrame(
      bezierCurve([
        [0, 0, 0],
        [1, 0, 0],
        [2, 0, 0],
        [3, 1, 1],
      ]),
      0,
    ),
  ).toBeNull();
  expect(
    frenetFrame(
      bezierCurve([
        [0, 0, 0],
        [0, 0, 0],
        [2, 0, 0],
        [3, 1, 1],
      ]),
      0,
    ),
  ).toBeNull();
  expect(() =>
    frenetFrame(
      bezierCurve([
        [0, 0],
        [1, 1],
      ]),
      0,
    ),
  ).toThrow("curve: expected a curve in 3 dimensions, got 2");
});

test("the plane frame has its normal to the left", () => {
  const frame = planeFrame(
    bezierCurve([
      [0, 0],
      [1, 1],
      [3, 1],
    ]),
    1,
  )!;
  expect(frame.point).toEqual([3, 1]);
  expect(frame.tangent).toEqual([1, 0]);
  expect(frame.normal[0]).toBeCloseTo(0, 15);
  expect(frame.normal[1]).toBe(1);
  expect(planeFrame(bezierCurve([[1, 1]]), 0)).toBeNull();
  expect(
    planeFrame(
      bezierCurve([
        [0, 0],
        [0, 0],
        [2, 0],
        [3, 1],
      ]),
      0,
    )!.normal[1],
  ).toBe(1);
  expect(() => planeFrame(space, 0)).toThrow("curve: expected a curve in 2 dimensions, got 3");
});

test("rotation-minimising frames are orthonormal, at every parameter asked for", () => {
  const ts = [0, 0.1, 0.5, 0.75, 1];
  forAll([points(2, 5, 3)], (b) => {
    const curve = bezierCurve(b);
    fc.pre(norm(curve.derivative(0)) > 1e-3);
    const frames = rotationMinimisingFrames(curve, ts, 0.1);
    expect(frames).toHaveLength(5);
    frames.forEach((frame, i) => {
      expectOrthonormal(frame);
      expect(frame.point).toEqual(curve.point(ts[i]!));
    });
  });
});

test("along a helix the frame turns back by torsion times arc length against Frenet's", () => {
  const ts = Array.from({ length: 11 }, (_, i) => i);
  const start = frenetFrame(helix, 0)!;
  const frames = rotationMinimisingFrames(helix, ts, 1e-8, start.normal);
  expect(distance(frames[0]!.normal, start.normal)).toBeLessThan(1e-12);
  frames.forEach(({ normal }, t) => {
    const frenet = frenetFrame(helix, t)!;
    const turned = Math.atan2(dot(normal, frenet.binormal), dot(normal, frenet.normal));
    const expected = -(4 / 25) * 5 * t;
    expect(Math.cos(turned - expected)).toBeCloseTo(1, 12);
    expect(Math.sin(turned - expected)).toBeCloseTo(0, 6);
  });
});

test("a coarser accuracy gives a coarser frame, still near", () => {
  const exact = rotationMinimisingFrames(helix, [0, 10], 1e-9)[1]!;
  const coarse = rotationMinimisingFrames(helix, [0, 10], 0.3)[1]!;
  expect(angleBetween(exact.normal, coarse.normal)).toBeLessThan(0.3);
  expect(angleBetween(exact.normal, coarse.normal)).toBeGreaterThan(1e-9);
});

test("in a plane the normal keeps its angle to the plane", () => {
  const plane = bezierCurve([
    [0, 0, 0],
    [1, 3, 0],
    [4, 3, 0],
    [5, -2, 0],
  ]);
  for (const { normal } of rotationMinimisingFrames(plane, [0, 0.3, 0.6, 1], 1e-6, [0, 0, 1])) {
    expect(distance(normal, [0, 0, 1])).toBeLessThan(1e-9);
  }
  for (const { binormal } of rotationMinimisingFrames(plane, [0, 0.3, 0.6, 1], 1e-6, [-2, 1, 0])) {
    expect(Math.abs(binormal[2]!)).toBeCloseTo(1, 9);
  }
});

test("the first normal: the wish made perpendicular, else across the axis farthest from the tangent", () => {
  const line = bezierCurve([
    [0, 0, 0],
    [2, 0, 0],
  ]);
  const first = (start?: readonly number[]) => rotationMinimisingFrames(line, [0, 1], 0.1, start);
  expect(first([5, 0, 7])[0]!.normal).toEqual([0, 0, 1]);
  expect(first([5, 0, 7])[1]!.normal).toEqual([0, 0, 1]);
  expect(first()[0]!.normal).toEqual([0, 1, 0]);
  expect(first([3, 0, 0])[0]!.normal).toEqual([0, 1, 0]);
  forAll([unit], (t) => {
    expect(rotationMinimisingFrames(space, [t], 0.1)).toHaveLength(1);
  });
});

test("a stop on the way keeps the frame", () => {
  const there: Curve = {
    dimension: 3,
    domain: [0, 3],
    breaks: [1, 2],
    point: (t) => [Math.min(1, t) + Math.max(0, t - 2), 0, 0],
    derivative: (t, r = 1) => [r === 1 && (t < 1 || t >= 2) ? 1 : 0, 0, 0],
    speed: 1,
  };
  const frames = rotationMinimisingFrames(there, [0, 1.5, 3], 1e-3, [0, 0, 1]);
  for (const { normal, tangent } of frames)
    expect([normal, tangent]).toEqual([
      [0, 0, 1],
      [1, 0, 0],
    ]);
});

test("bad arguments are named", () => {
  expect(() =>
    rotationMinimisingFrames(
      bezierCurve([
        [0, 0],
        [1, 1],
      ]),
      [0],
      0.1,
    ),
  ).toThrow(/^curve: expected a curve in 3/);
  expect(() => rotationMinimisingFrames(space, [], 0.1)).toThrow(/^ts: expected at least 1 number/);
  expect(() => rotationMinimisingFrames(space, [0, 0], 0.1)).toThrow(/^ts\[1\]: expected a number greater/);
  expect(() => rotationMinimisingFrames(space, [0, 1], 0)).toThrow(/^accuracy: /);
  expect(() => rotationMinimisingFrames(bezierCurve([[1, 1, 1]]), [0, 1], 0.1)).toThrow(
    "curve: expected a direction at ts[0] = 0, but it stands still there",
  );
  expect(() => rotationMinimisingFrames(space, [0, 1], 0.1, [1, 2])).toThrow(
    /^start: expected 3 coordinates/,
  );
});
