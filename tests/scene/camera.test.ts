import { expect, test } from "vitest";
import { axesOf, type Camera, FLAT, flatView } from "../../src/scene/camera.ts";
import { fitSpace, spaceView } from "../../src/scene/space.ts";

const dot = (a: readonly number[], b: readonly number[]) => a.reduce((sum, x, k) => sum + x * b[k]!, 0);
const words = { de: "Raum", en: "space" };
const box = { left: 10, top: 20, width: 500, height: 300 };
const view = (camera: Camera) => {
  const made = spaceView({ label: words, target: [1, -2, 0.5], radius: 2, height: 0.6 });
  return fitSpace({ ...made, space: { ...made.space, camera } }, box);
};

test("right, up and eye are of length 1, at right angles and right-handed, from everywhere", () => {
  for (let yaw = -180; yaw <= 180; yaw += 30) {
    for (let pitch = -90; pitch <= 90; pitch += 15) {
      const { right, up, eye } = axesOf([yaw, pitch, 8]);
      for (const axis of [right, up, eye]) expect(dot(axis, axis)).toBeCloseTo(1, 12);
      expect(dot(right, up)).toBeCloseTo(0, 12);
      expect(dot(up, eye)).toBeCloseTo(0, 12);
      // right × up = eye
      expect(right[1]! * up[2]! - right[2]! * up[1]!).toBeCloseTo(eye[0]!, 12);
      expect(right[2]! * up[0]! - right[0]! * up[2]!).toBeCloseTo(eye[1]!, 12);
    }
  }
});

test("the flat views look exactly along an axis", () => {
  const exactly = (name: keyof typeof FLAT) => axesOf([...FLAT[name], 8]);
  expect(exactly("top")).toEqual({ right: [1, 0, 0], up: [-0, 1, 0], eye: [0, -0, 1] });
  expect(exactly("front").eye).toEqual([0, -1, 0]);
  expect(exactly("side").eye.map((x) => x + 0)).toEqual([1, 0, 0]);
  expect(flatView([0, 90, 3])).toBe("top");
  expect(flatView([0, 89.9, 3])).toBeNull();
});

test("a window shows its radius to each side, whatever the direction", () => {
  for (const camera of [
    [30, 25, 8],
    [0, 90, 8],
    [200, -60, 8],
  ] as const) {
    const { space, toPixel } = view(camera);
    expect(toPixel([1, -2, 0.5])).toEqual([260, 170]);
    const edge = [1, -2, 0.5].map((x, k) => x + 2 * space.axes.up[k]!);
    expect(toPixel(edge)[1]).toBeCloseTo(20, 9);
  }
});

test("a place of the picture is lifted into the plane through a point, parallel to the picture", () => {
  const { space, toPixel } = view([40, 30, 8]);
  const through = [0.3, -1.7, 1.1];
  const lifted = space.lift([300, 100], through);
  expect(toPixel(lifted)[0]).toBeCloseTo(300, 9);
  expect(toPixel(lifted)[1]).toBeCloseTo(100, 9);
  expect(space.project(lifted)[2]).toBeCloseTo(space.project(through)[2], 12);
});

test("in a flat view lifting keeps the third coordinate to the last bit", () => {
  const through = [0.1 + 0.2, 1 / 3, 2 / 7];
  expect(view([0, 90, 8]).space.lift([123, 77], through)[2]).toBe(2 / 7);
  expect(view([0, 0, 8]).space.lift([123, 77], through)[1]).toBe(1 / 3);
  expect(view([90, 0, 8]).space.lift([123, 77], through)[0]).toBe(0.1 + 0.2);
});
