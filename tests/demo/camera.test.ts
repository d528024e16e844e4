import { expect, test } from "vitest";
import { viewpoint } from "../../src/demo/describe-camera.ts";
import { figureOf } from "../../src/demo/figure.ts";
import { defineDemo, net, number } from "../../src/demo/index.ts";
import { camera } from "../../src/demo/params/camera.ts";
import { readQuery, writeQuery } from "../../src/demo/query.ts";
import { changed, initialState } from "../../src/demo/state.ts";
import { spaceView } from "../../src/scene/space.ts";

const label = { de: "Netz", en: "net" };
const demo = defineDemo({
  id: "in-space",
  title: { de: "Raum", en: "Space" },
  params: {
    points: net({ initial: [[[0, 0, 0], [0, 1, 1]], [[1, 0, 1], [1, 1, 0]]], label, range: [-4, 4] }), // biome-ignore format: a net
  },
  views: { space: spaceView({ label, radius: 2, yaw: 30, pitch: 20, height: 0.6 }) },
  values: () => ({}),
  scene: () => ({ space: [] }),
  describe: () => ({ de: "Ein Netz.", en: "A net." }),
  states: { above: { camera: "top" } },
});

test("a demo that looks into space has its camera in the state, others have none", () => {
  expect(initialState(demo).camera).toEqual([30, 20, 8]);
  const flat = {
    ...demo,
    id: "flat",
    params: {},
    views: { plane: { label, x: [0, 1], y: [0, 1], height: 1 } },
  } as const;
  expect(Object.keys(defineDemo({ ...flat, states: {} }).params)).toEqual([]);
});

test("authors cannot name a parameter camera", () => {
  const params = { camera: number({ initial: 0, min: 0, max: 1, step: 1, label }) };
  expect(() => defineDemo({ ...demo, params } as unknown as Parameters<typeof defineDemo>[0])).toThrow(
    /reserved/,
  );
});

test("is read from the names of the flat views and from yaw, pitch, distance", () => {
  const read = (text: string) => readQuery(demo, `camera=${text}`);
  expect(read("top").patch.camera).toEqual([0, 90, 8]);
  expect(read("front").patch.camera).toEqual([0, 0, 8]);
  expect(read("side").patch.camera).toEqual([90, 0, 8]);
  expect(read("-120,12.5,6").patch.camera).toEqual([-120, 12.5, 6]);
  for (const text of ["below", "1,2", "0,91,8", "0,0,0", "400,0,8", "NaN,0,8", ""]) {
    expect(read(text).problems[0]?.param, text).toBe("camera");
  }
});

test("is written as short as it can be read, and named states know the names", () => {
  const base = initialState(demo);
  const query = (value: readonly number[]) => writeQuery(demo, changed(demo, base, { camera: value }), base);
  expect(query([30, 20, 8])).toBe("");
  expect(query([0, 90, 8])).toBe("camera=top");
  expect(query([0, 90, 4])).toBe("camera=0,90,4");
  expect(demo.states!.above!.camera).toEqual([0, 90, 8]);
});

test("glides the short way round and keeps few decimals", () => {
  const param = camera([0, 0, 8]);
  expect(param.between([170, 0, 8], [-170, 10, 2], 0.5)).toEqual([180, 5, 4]);
  expect(param.round([190.123, 12.36, 7.123456])).toEqual([-169.9, 12.4, 7.123]);
});

test("is said with the figure, and the view changes with it", () => {
  const from = (value: readonly number[]) =>
    figureOf(demo, changed(demo, initialState(demo), { camera: value }));
  expect(from([30, 20, 8]).description.en).toBe(
    "A net. Seen turned 30° to the right of the front, 20° from above.",
  );
  expect(from([0, 90, 8]).description.de).toBe("Ein Netz. Ansicht von oben: x nach rechts, y nach oben.");
  expect(viewpoint([-15, -5, 8]).de).toBe("Blick von vorn um 15° nach links gedreht, 5° von unten.");
  expect(from([0, 90, 8]).views.space!.space!.camera).toEqual([0, 90, 8]);
  expect(demo.views.space!.space!.camera).toEqual([30, 20, 8]);
});

test("handles of a net take points of space; a coordinate that stays keeps its very number", () => {
  const start = changed(demo, initialState(demo), {
    points: [[[0.123456, 0, 0], [0, 1, 1]], [[1, 0, 1], [1, 1, 0]]], // biome-ignore format: a net
  });
  const handle = figureOf(demo, start).handles[0]!;
  const moved = handle.put([0.123456, 0.456, 0.789]) as readonly (readonly (readonly number[])[])[];
  expect(moved[0]![0]).toEqual([0.123456, 0.46, 0.79]);
  const nudged = handle.nudge([0, 0, 1], 1) as typeof moved;
  expect(nudged[0]![0]![2]).toBeCloseTo(0.08, 12);
});
