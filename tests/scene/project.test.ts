import { expect, test } from "vitest";
import { bezierPatch, bezierPoint } from "../../src/math/index.ts";
import type { Camera } from "../../src/scene/camera.ts";
import { arrow, label, path, point, polyline } from "../../src/scene/draw.ts";
import type { FacetsMark, Mark, PathMark, PathStep, PointMark } from "../../src/scene/marks.ts";
import { project } from "../../src/scene/project.ts";
import { fitSpace, spaceView } from "../../src/scene/space.ts";
import { ground, patch, sampleSurface } from "../../src/scene/surfaces.ts";

const made = spaceView({ label: { de: "Raum", en: "space" }, radius: 3, height: 0.6 });
const box = { left: 0, top: 0, width: 600, height: 360 };
const spaceFrom = (camera: Camera) => fitSpace({ ...made, space: { ...made.space, camera } }, box).space;
const fromTop = spaceFrom([0, 90, 12]);

/** The level square −1 … 1 at height z; its front side is above. */
const square = (key: string, z: number, half = 1) =>
  patch(
    key,
    sampleSurface(
      bezierPatch([
        [[-half, -half, z], [-half, half, z]],
        [[half, -half, z], [half, half, z]],
      ]), // biome-ignore format: four corners
      [8, 8],
    ),
  );

const seen = (marks: readonly Mark[], key: string) => marks.find((mark) => mark.key === key);
const facets = (marks: readonly Mark[]) =>
  (marks.find((mark) => mark.kind === "facets") as FacetsMark | undefined)?.facets ?? [];
const ends = (steps: readonly PathStep[]) => steps.map((step) => step.at(-1) as readonly number[]);
const lengthOf = (steps: readonly PathStep[]) => {
  let total = 0;
  steps.forEach((step, k) => {
    if (step[0] !== "L") return;
    const [from, to] = [ends(steps)[k - 1]!, step[1]];
    total += Math.hypot(to[0]! - from[0]!, to[1]! - from[1]!);
  });
  return total;
};

test("a Bézier arc of space is the exact arc of the picture", () => {
  const space = spaceFrom([37, 21, 12]);
  const control = [[0, 0, 0], [1, 2, 0.5], [2, -1, 1.5], [2.5, 1, -1]]; // biome-ignore format: four points
  const steps: PathStep[] = [["M", control[0]!], ["C", control[1]!, control[2]!, control[3]!]]; // biome-ignore format: one arc
  const [drawn] = project([path("arc", "curve", steps)], space, { facets: 100 }) as [PathMark];
  expect(drawn.steps.map(([letter]) => letter)).toEqual(["M", "C"]);
  const flat = [drawn.steps[0]![1]!, ...(drawn.steps[1]!.slice(1) as (readonly number[])[])];
  for (const t of [0, 0.2, 0.5, 0.9, 1]) {
    const expected = space.project(bezierPoint(control, t));
    for (const [k, x] of bezierPoint(flat, t).entries()) expect(x).toBeCloseTo(expected[k]!, 12);
  }
});

test("a line is cut where it goes behind a surface; both parts together are the whole line", () => {
  const line = polyline("line", "control-polygon", [[-2.5, 0.2, -1], [2.5, 0.2, -1]]); // biome-ignore format: two points
  const marks = project([square("roof", 1), line], fromTop, { facets: 100 });
  const [front, behind] = [seen(marks, "line") as PathMark, seen(marks, "line-behind") as PathMark];
  expect(lengthOf(front.steps)).toBeCloseTo(3, 2);
  expect(lengthOf(behind.steps)).toBeCloseTo(2, 2);
  expect(behind.fade).toBeLessThan(1);
  expect(front.fade).toBeUndefined();
  for (const [x] of ends(behind.steps)) expect(Math.abs(x!)).toBeCloseTo(1, 2);
});

test("a line in front of a surface, and one on it, are seen whole", () => {
  const lines = [0.5, 0].map(
    (above, k) =>
    polyline(`line-${k}`, "curve", [[-2, 0.1, 1 + above], [2, 0.1, 1 + above]]), // biome-ignore format: two points
  );
  const marks = project([square("roof", 1), ...lines], fromTop, { facets: 100 });
  expect(marks.filter((mark) => mark.key.endsWith("behind"))).toEqual([]);
});

test("a curved line on a curved surface is seen on the side that faces the eye, not on the other", () => {
  const bowl = bezierPatch([
    [[-1, -1, 0], [-1, 1, 0]],
    [[0, -1, 3], [0, 1, 3]],
    [[1, -1, 0], [1, 1, 0]],
  ]); // biome-ignore format: an arch
  const arch: PathStep[] = [["M", bowl.point(0, 0.5)], ["Q", [0, 0, 3], bowl.point(1, 0.5)]]; // biome-ignore format: one arc
  const marks = [patch("arch", sampleSurface(bowl, [24, 4])), path("rib", "curve", arch)];
  const shown = (camera: Camera, part: string) =>
    seen(project(marks, spaceFrom(camera), { facets: 100 }), part);
  expect(shown([0, 90, 12], "rib-behind")).toBeUndefined();
  // From the side, low, the far half lies behind the near one.
  const far = shown([90, 10, 12], "rib-behind") as PathMark;
  expect(far.steps.length).toBeGreaterThan(1);
});

test("lines of the surface itself are not drawn where it hides them", () => {
  const line = polyline("line", "mesh", [[-0.5, 0, 0], [0.5, 0, 0]]); // biome-ignore format: two points
  const marks = project([square("roof", 1), line], fromTop, { facets: 100 });
  expect(marks.map((mark) => mark.key)).not.toContain("line-behind");
  expect(marks.map((mark) => mark.key)).not.toContain("line");
});

test("points behind a surface are faint, far ones smaller than near ones, and near ones are drawn last", () => {
  const marks = project(
    [square("roof", 1), point("near", "handle", [2, 0, 2]), point("far", "handle", [0, 0, -1])],
    fromTop,
    { facets: 100 },
  );
  const [near, far] = [seen(marks, "near") as PointMark, seen(marks, "far") as PointMark];
  expect(far.fade).toBeLessThan(1);
  expect(near.fade).toBeUndefined();
  expect(near.scale!).toBeGreaterThan(far.scale!);
  expect(marks.indexOf(near)).toBeGreaterThan(marks.indexOf(far));
});

test("facets come from the farthest to the nearest, and none that is wholly hidden", () => {
  const space = spaceFrom([0, 90, 12]);
  const both = facets(project([square("roof", 1, 0.5), square("floor", 0, 1)], space, { facets: 400 }));
  // The 8 × 8 cells of the roof cover the middle 4 × 4 cells of the floor; those at its rim are seen in part.
  expect(both.length).toBeLessThan(128);
  expect(both.length).toBeGreaterThan(64 + 64 - 20);
  const isRoof = both.map(({ corners }) => Math.abs(corners[0]![0]! - corners[2]![0]!) < 0.2);
  expect(isRoof.lastIndexOf(false)).toBeLessThan(isRoof.indexOf(true));
});

test("the side S_u × S_v points to is the front; from below the other side is seen", () => {
  const above = facets(project([square("roof", 1)], fromTop, { facets: 100 }));
  const below = facets(project([square("roof", 1)], spaceFrom([0, -90, 12]), { facets: 100 }));
  expect(above.every(({ colour }) => "between" in colour && colour.between === "front")).toBe(true);
  expect(below.every(({ colour }) => "between" in colour && colour.between === "back")).toBe(true);
  expect(above).toHaveLength(64);
});

test("surfaces are thinned out to the budget, and left to others where it is 0", () => {
  const one = patch("fine", sampleSurface(bezierPatch([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0]]]), [40, 40])); // biome-ignore format: four corners
  expect(facets(project([one], fromTop, { facets: 100 })).length).toBeLessThanOrEqual(100);
  const [left] = project([one], fromTop, { facets: 0 }) as [FacetsMark];
  expect(left.facets).toEqual([]);
  expect(left.patches).toEqual([one]);
});

test("the ground with its shadow lies behind everything from above, before it from below", () => {
  const marks = [ground(-1, [-2, 2], [-2, 2], 1), square("roof", 1)];
  const kinds = (camera: Camera) =>
    project(marks, spaceFrom(camera), { facets: 100 }).map((mark) => `${mark.kind} ${mark.role}`);
  expect(kinds([30, 30, 12])).toEqual(["path grid", "path shadow", "facets surface"]);
  expect(kinds([30, -30, 12])).toEqual(["facets surface", "path grid"]);
});

test("the shadow covers the ground below a surface, wherever its cells turn", () => {
  const marks = project([ground(-1, [-2, 2], [-2, 2]), square("roof", 1)], fromTop, { facets: 100 });
  const shadow = marks.find((mark) => mark.role === "shadow") as PathMark;
  let area = 0;
  for (let k = 0; k < shadow.steps.length; k += 5) {
    const [a, b, c, d] = ends(shadow.steps.slice(k, k + 4)) as [number[], number[], number[], number[]];
    const twice = (c[0]! - a[0]!) * (d[1]! - b[1]!) - (d[0]! - b[0]!) * (c[1]! - a[1]!);
    expect(twice).toBeGreaterThan(0);
    area += twice / 2;
  }
  expect(area).toBeCloseTo(4, 9);
});

test("an arrow whose tip is hidden is faint; one that comes out of a surface keeps its head", () => {
  const down = arrow("down", "tangent", [0, 0, 2], [0, 0.5, 0]);
  const up = arrow("up", "tangent", [0, 0.5, 0], [0, 2.5, 2]);
  const marks = project([square("roof", 1), down, up], fromTop, { facets: 100 });
  expect(seen(marks, "down")!.fade).toBeLessThan(1);
  const head = seen(marks, "up")!;
  expect(head.kind).toBe("arrow");
  expect(head.fade).toBeUndefined();
  expect(seen(marks, "up-behind")!.kind).toBe("path");
});

test("labels turn with their points; a raster has no place in space", () => {
  const marks = project(
    [label("l", "note", [0, 0, 1], { base: "a" }, { toward: [0, 0, 1] })],
    spaceFrom([0, 0, 12]),
    {
      facets: 0,
    },
  );
  expect(marks).toEqual([expect.objectContaining({ kind: "label", at: [0, 1], toward: [0, 1] })]);
  const raster: Mark = {
    kind: "raster",
    key: "r",
    role: "note",
    x: [0, 1],
    y: [0, 1],
    columns: 1,
    rows: 1,
    values: [1],
    range: [0, 1],
    colours: "sequential",
  };
  expect(() => project([raster], fromTop, { facets: 0 })).toThrow(/raster has no place in space/);
});
