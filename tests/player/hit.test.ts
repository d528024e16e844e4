import { expect, test } from "vitest";
import type { Figure } from "../../src/demo/figure.ts";
import { markAt } from "../../src/player/hit.ts";
import { disc, path, point, polyline, region } from "../../src/scene/draw.ts";
import type { Mark, XY } from "../../src/scene/marks.ts";

const NONE = new Set<string>();
const at = (marks: readonly Mark[], x: number, y: number, handles: ReadonlySet<string> = NONE) =>
  markAt({ scene: { plane: marks } } as unknown as Figure, x, y, (_, p: XY) => [p[0]!, p[1]!], handles);

const square = region(
  "s",
  "hull",
  [
    [0, 0],
    [100, 0],
    [100, 100],
    [0, 100],
  ],
  { name: "square" },
);
const line = polyline(
  "l",
  "curve",
  [
    [0, 50],
    [100, 50],
  ],
  { name: "line" },
);
const dot = point("d", "curve", [50, 50], { name: "dot" });

test("a point is nearer than a line, a line than the region below", () => {
  expect(at([square, line, dot], 52, 52)).toBe("dot");
  expect(at([square, line, dot], 80, 53)).toBe("line");
  expect(at([square, line, dot], 80, 80)).toBe("square");
  expect(at([square, line, dot], 180, 80)).toBeNull();
});

test("arcs are hit along the curve, not along their polygon", () => {
  const arc = path(
    "a",
    "curve",
    [
      ["M", [0, 0]],
      ["Q", [50, 100], [100, 0]],
    ],
    { name: "arc" },
  );
  expect(at([arc], 50, 50)).toBe("arc");
  expect(at([arc], 50, 90)).toBeNull();
});

test("discs are hit by their area; of overlapping ones the last is on top", () => {
  const discs = [disc("a", [0, 0], 1, { name: "a" }), disc("b", [10, 0], 0.25, { name: "b" })];
  expect(at(discs, 12, 0)).toBe("b");
  expect(at(discs, -20, 0)).toBe("a");
});

test("marks without a name and handles are passed over", () => {
  expect(at([point("x", "curve", [0, 0])], 0, 0)).toBeNull();
  expect(at([dot], 50, 50, new Set(["dot"]))).toBeNull();
});
