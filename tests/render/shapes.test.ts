import { describe, expect, test } from "vitest";
import { arrow } from "../../src/render/arrow.ts";
import { INDEX_COUNT } from "../../src/render/palette.ts";
import { SHAPES, shapeOf, shapeSteps } from "../../src/render/shapes.ts";
import { SIZE } from "../../src/render/sizes.ts";
import type { PathStep, XY } from "../../src/scene/marks.ts";

const corners = (steps: readonly PathStep[]) => steps.flatMap((step) => step.slice(1) as XY[]);

function area(points: readonly XY[]): number {
  const twice = points.reduce((sum, p, i) => {
    const q = points[(i + 1) % points.length]!;
    return sum + p[0]! * q[1]! - q[0]! * p[1]!;
  }, 0);
  return Math.abs(twice) / 2;
}

describe("the shapes of the index", () => {
  test("one for each colour, all different, starting with the disc", () => {
    expect(new Set(SHAPES).size).toBe(INDEX_COUNT);
    expect(shapeOf(undefined)).toBe("disc");
    expect(shapeOf(0)).toBe("disc");
    expect(shapeOf(INDEX_COUNT + 2)).toBe(shapeOf(2));
    const outlines = SHAPES.filter((shape) => shape !== "disc").map((s) =>
      JSON.stringify(shapeSteps(s, [0, 0], 5)),
    );
    expect(new Set(outlines).size).toBe(INDEX_COUNT - 1);
  });

  test.each(SHAPES.filter((shape) => shape !== "disc"))(
    "%s stays within a handle's ring and looks as large",
    (s) => {
      const points = corners(shapeSteps(s, [20, 10], SIZE.shape));
      for (const [x, y] of points) expect(Math.hypot(x! - 20, y! - 10)).toBeLessThan(SIZE.ring - 0.9);
      expect(area(points) / (Math.PI * SIZE.shape ** 2)).toBeGreaterThan(0.6);
      expect(area(points) / (Math.PI * SIZE.shape ** 2)).toBeLessThan(1.2);
    },
  );
});

describe("arrows", () => {
  test("the head's tip is the vector's end, the shaft ends inside the head", () => {
    const { shaft, head } = arrow([0, 0], [100, 0])!;
    expect(head[0]).toEqual(["M", [100, 0]]);
    expect(corners(shaft)[0]).toEqual([0, 0]);
    const [end] = corners(shaft).slice(-1);
    expect(end![0]).toBeGreaterThan(100 - SIZE.arrowLength);
    expect(end![0]).toBeLessThan(100);
    expect(area(corners(head))).toBeGreaterThan(20);
  });

  test("a short one keeps its proportions and never points backwards", () => {
    const { shaft, head } = arrow([0, 0], [0, 4])!;
    for (const [, y] of [...corners(shaft), ...corners(head)]) {
      expect(y).toBeGreaterThanOrEqual(-1e-9);
      expect(y).toBeLessThanOrEqual(4);
    }
  });

  test("no length, no direction, no arrow", () => {
    expect(arrow([3, 3], [3, 3])).toBeNull();
    expect(arrow([3, 3], [3.2, 3.2])).toBeNull();
  });
});
