import { expect, test } from "vitest";
import { axesOf } from "../../src/scene/camera.ts";
import { inPicture, LIGHT, litShare, normalColour, stripeShare, valueShare } from "../../src/scene/shade.ts";

const directions = Array.from({ length: 200 }, (_, k) => {
  // Points of a spiral around the sphere.
  const z = 1 - (2 * k + 1) / 200;
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(k * 2.4), r * Math.sin(k * 2.4), z];
});

test("brightness lies between 0 and 1, is greatest towards the light and grows with it", () => {
  const shares = directions.map(litShare);
  for (const share of shares) {
    expect(share).toBeGreaterThanOrEqual(0);
    expect(share).toBeLessThanOrEqual(1);
  }
  // Away from the light by more than 45 degrees, everything is darker than what faces it.
  for (const n of directions) {
    const cosine = n.reduce((sum, x, k) => sum + x * LIGHT[k]!, 0);
    if (cosine < Math.SQRT1_2) expect(litShare(n)).toBeLessThan(litShare(LIGHT));
  }
  expect(litShare(LIGHT.map((x) => -x))).toBeLessThan(0.1);
});

test("stripes run level around the picture: mirrored left and right they are the same", () => {
  for (const [x, y, z] of directions) {
    expect(stripeShare([-x!, y!, z!])).toBeCloseTo(stripeShare([x!, y!, z!]), 12);
  }
  expect(new Set(directions.map(stripeShare).map(Math.round)).size).toBe(2);
});

test("normals have their usual colours", () => {
  expect(normalColour([1, 0, 0])).toEqual([255, 128, 128]);
  expect(normalColour([0, 0, -1])).toEqual([128, 128, 0]);
});

test("values are placed on the map between its ends; none where there is none", () => {
  expect([-9, -1, 0, 1, 9].map((x) => valueShare(x, [-1, 1]))).toEqual([0, 0, 0.5, 1, 1]);
  expect(valueShare(Number.NaN, [-1, 1])).toBeNull();
  expect(valueShare(3, [2, 2])).toBe(0.5);
});

test("a normal in the directions of the picture keeps its length", () => {
  const axes = axesOf([33, 12, 5]);
  for (const n of directions) expect(Math.hypot(...inPicture(n, axes))).toBeCloseTo(1, 12);
  expect(inPicture(axes.eye, axes)[2]).toBeCloseTo(1, 12);
});
