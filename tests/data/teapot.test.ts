import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { teapot, teapotParts } from "../../src/data/teapot.ts";
import { coordinates, indices } from "../../src/data/teapot-numbers.ts";
import { bezierPatch, dot, isCollapsed, limitNormal, surfaceNormal } from "../../src/math/index.ts";

/** The four edges of a net as lists of points. */
const edges = (net: (typeof teapot)[number]) => [
  net[0]!,
  net[3]!,
  net.map((row) => row[0]!),
  net.map((row) => row[3]!),
];
const text = (points: readonly (readonly number[])[]) => {
  const forth = points.map(String).join(" ");
  const back = points.map(String).reverse().join(" ");
  return [forth, back].sort()[0]!;
};

test("has 32 patches of 16 points, 290 different ones, each of them used", () => {
  expect(teapot).toHaveLength(32);
  expect(coordinates).toHaveLength(3 * 290);
  expect(new Set(indices)).toEqual(new Set(Array.from({ length: 290 }, (_, i) => i)));
  expect(teapotParts.map(({ from, to }) => to - from)).toEqual([4, 8, 4, 4, 8, 4]);
  for (const net of teapot) expect(net.flat(2).every(Number.isFinite)).toBe(true);
});

test("has the numbers of the published table", () => {
  const url = new URL("../../node_modules/three/examples/jsm/geometries/TeapotGeometry.js", import.meta.url);
  const source = readFileSync(url, "utf8");
  const table = (name: string) => {
    const body = source
      .split(`const ${name} = [`)[1]!
      .split("];")[0]!
      .replace(/\/\*.*?\*\/|\s/g, "");
    return body
      .split(",")
      .filter((word) => word !== "")
      .map(Number);
  };
  expect(coordinates).toEqual(table("teapotVertices"));
  expect(indices).toEqual(table("teapotPatches"));
});

test("stands on the ground and is mirrored at the plane through handle and spout", () => {
  const z = coordinates.filter((_, i) => i % 3 === 2);
  expect([Math.min(...z), Math.max(...z)]).toEqual([0, 3.15]);
  const all = new Set(teapot.flat(2).map(([x, y, zz]) => `${x} ${y} ${zz}`));
  for (const [x, y, zz] of teapot.flat(2)) expect(all).toContain(`${x} ${y === 0 ? 0 : -y!} ${zz}`);
});

test("closes each part all around: edges are shared, but those of openings and tips", () => {
  for (const { id, from, to } of teapotParts) {
    const count = new Map<string, number>();
    for (const net of teapot.slice(from, to)) {
      for (const edge of edges(net)) {
        if (edge.every((point) => String(point) === String(edge[0]))) continue; // a tip
        count.set(text(edge), (count.get(text(edge)) ?? 0) + 1);
      }
    }
    const open = [...count.values()].filter((times) => times === 1).length;
    expect(Math.max(...count.values()), id).toBe(2);
    // Rings of four patches have two open ends of four edges; handle and spout are rings of two.
    const expected = { rim: 8, body: 8, handle: 4, spout: 4, lid: 4, bottom: 4 }[id];
    expect(open, id).toBe(expected);
  }
});

test("turns its normals outwards: away from the axis on the body, up on the lid, down on the bottom", () => {
  for (const { id, from, to } of teapotParts) {
    for (const net of teapot.slice(from, to)) {
      const surface = bezierPatch(net);
      const [x, y] = surface.point(0.5, 0.5);
      const normal = surfaceNormal(surface, 0.5, 0.5)!;
      if (id === "body") expect(dot(normal, [x!, y!, 0])).toBeGreaterThan(0);
      if (id === "bottom") expect(normal[2]).toBeLessThan(0);
    }
  }
  for (const net of teapot.slice(20, 24)) expect(limitNormal(bezierPatch(net), 0.3, 0)![2]).toBeCloseTo(1, 6);
  for (const net of teapot.slice(24, 28))
    expect(surfaceNormal(bezierPatch(net), 0.5, 0.5)![2]).toBeGreaterThan(0.9);
});

test("has edges that are points at the top of the lid and the middle of the bottom, with a normal in the limit", () => {
  const collapsed = teapot.flatMap((net, k) => {
    const surface = bezierPatch(net);
    return (["u", "v"] as const).flatMap((fixed) =>
      [0, 1].filter((value) => isCollapsed(surface, fixed, value)).map((value) => ({ k, fixed, value })),
    );
  });
  expect(new Set(collapsed.map(({ k }) => k))).toEqual(new Set([20, 21, 22, 23, 28, 29, 30, 31]));
  for (const { k, fixed, value } of collapsed) {
    const surface = bezierPatch(teapot[k]!);
    const [u, v] = fixed === "u" ? [value, 0.3] : [0.3, value];
    expect(surfaceNormal(surface, u, v)).toBeNull();
    expect(Math.abs(limitNormal(surface, u, v)![2]!)).toBeCloseTo(1, 6);
  }
});
