import fc from "fast-check";
import { expect, test } from "vitest";
import { aspect, layoutViews } from "../../src/scene/layout.ts";
import { fitView, type View } from "../../src/scene/view.ts";

const label = { de: "a", en: "b" };
const plane: View = { label, x: [0, 4], y: [0, 3], height: 0.5, narrowHeight: 0.8 };
const side: View = { label, x: [0, 1], y: [0, 1], fit: "stretch", height: 0.4, beside: 0.25, axes: {} };
const bar: View = { label, x: [0, 1], y: [0, 1], fit: "stretch", height: 0.1, narrowHeight: 0.15 };
const views = { plane, side, bar };

test("the height follows from the rows, in each layout its own", () => {
  expect(aspect(views, false)).toBeCloseTo(0.6);
  expect(aspect(views, true)).toBeCloseTo(0.8 + 0.56 + 0.15);
});

test("windows do not overlap and stay inside, at any size", () => {
  fc.assert(
    fc.property(fc.integer({ min: 200, max: 2000 }), fc.integer({ min: 150, max: 1500 }), (width, height) => {
      const boxes = Object.values(layoutViews(views, width, height));
      for (const [i, a] of boxes.entries()) {
        expect(a.left).toBeGreaterThanOrEqual(0);
        expect(a.top + a.height).toBeLessThanOrEqual(height + 1e-9);
        expect(a.left + a.width).toBeLessThanOrEqual(width + 1e-9);
        for (const b of boxes.slice(i + 1)) {
          const apart =
            a.left + a.width <= b.left ||
            b.left + b.width <= a.left ||
            a.top + a.height <= b.top ||
            b.top + b.height <= a.top;
          expect(apart).toBe(true);
        }
      }
    }),
  );
});

test("a point goes to its pixel and back", () => {
  const box = { left: 10, top: 20, width: 300, height: 100 };
  for (const view of [plane, side]) {
    const fitted = fitView(view, box);
    const there = fitted.toPixel([0.3, 0.7]);
    const back = fitted.toWorld(there);
    expect(back[0]).toBeCloseTo(0.3);
    expect(back[1]).toBeCloseTo(0.7);
  }
});

test("an equal fit shows everything asked for, centred; a stretched one fills its box", () => {
  const box = { left: 0, top: 0, width: 400, height: 100 };
  const equal = fitView(plane, box);
  expect(equal.scale[0]).toBe(equal.scale[1]);
  expect(equal.y).toEqual([0, 3]);
  expect((equal.x[0] + equal.x[1]) / 2).toBeCloseTo(2);
  expect(equal.x[0]).toBeLessThanOrEqual(0);
  expect(fitView(side, box).toPixel([0, 0])).toEqual([0, 100]);
});

test("a bar keeps its height on a tall screen, the plane takes the rest", () => {
  const boxes = layoutViews({ plane, bar }, 400, 800);
  const natural = layoutViews({ plane, bar }, 400, 400 * aspect({ plane, bar }, true));
  expect(boxes.bar!.height).toBeCloseTo(natural.bar!.height);
  expect(boxes.plane!.height).toBeGreaterThan(natural.plane!.height + 300);
});
