import fc from "fast-check";
import { expect, test } from "vitest";
import { ticks } from "../../src/render/ticks.ts";

test("unit interval, 400 pixels wide: fifths", () => {
  expect(ticks([0, 1], 400, 52)).toEqual({ step: 0.2, values: [0, 0.2, 0.4, 0.6, 0.8, 1], digits: 1 });
});

test("around zero: no negative zero, no 0.30000000000000004", () => {
  const { values } = ticks([-0.35, 0.35], 520, 52);
  expect(values).toEqual([-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3]);
  expect(values.some((value) => Object.is(value, -0))).toBe(false);
});

test("large numbers have no decimals", () => {
  expect(ticks([0, 900], 1, 100)).toEqual({
    step: 100,
    values: [0, 100, 200, 300, 400, 500, 600, 700, 800, 900],
    digits: 0,
  });
});

test("the step is 1, 2 or 5 times a power of ten, far enough apart, not needlessly far", () => {
  fc.assert(
    fc.property(
      fc.double({ min: -1e4, max: 1e4, noNaN: true }),
      fc.double({ min: 1e-3, max: 1e4, noNaN: true }),
      fc.double({ min: 100, max: 2000, noNaN: true }),
      fc.double({ min: 20, max: 90, noNaN: true }),
      (from, length, pixels, spacing) => {
        const scale = pixels / length;
        const { step, values, digits } = ticks([from, from + length], scale, spacing);
        const lead = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
        expect([1, 2, 5].some((d) => Math.abs(lead - d) < 1e-6)).toBe(true);
        expect(step * scale).toBeGreaterThanOrEqual(spacing * (1 - 1e-6));
        expect(step * scale).toBeLessThanOrEqual(2.5 * spacing * (1 + 1e-6));
        for (const value of values) {
          expect(value).toBeGreaterThanOrEqual(from - step * 1e-5);
          expect(value).toBeLessThanOrEqual(from + length + step * 1e-5);
          expect(Number(value.toFixed(digits))).toBeCloseTo(value, 9);
        }
        expect(values.length).toBeGreaterThanOrEqual(Math.floor(length / step) - 1);
      },
    ),
  );
});

test.each([
  [[0, 1], 0],
  [[0, 1], Number.POSITIVE_INFINITY],
  [[0, 1], Number.NaN],
  [[0, Number.NaN], 100],
  [[1, 0], 100],
] as const)("a window that is none has no numbers: %j at %d", (interval, scale) => {
  expect(ticks(interval, scale, 50).values).toEqual([]);
});
