import fc from "fast-check";
import { describe, expect, test } from "vitest";
import type { LabelRequest } from "../../src/render/label-request.ts";
import { COVERED, type Obstacles, type Round } from "../../src/render/obstacles.ts";
import { placeLabels } from "../../src/render/place-labels.ts";
import type { Box } from "../../src/scene/view.ts";

const BOUNDS: Box = { left: 0, top: 0, width: 700, height: 400 };
const EMPTY: Obstacles = { circles: [], lines: [] };
const HANDLE = 10;

const handle = (x: number, y: number): Round => ({ x, y, r: HANDLE, price: COVERED.handle });

function request(x: number, y: number, extra: Partial<LabelRequest> = {}): LabelRequest {
  return { at: [x, y], width: 20, height: 16, clear: HANDLE, fixed: false, rank: 0, ...extra };
}

const overlaps = (a: Box, b: Box) =>
  a.left < b.left + b.width &&
  b.left < a.left + a.width &&
  a.top < b.top + b.height &&
  b.top < a.top + a.height;

/** The distance of a point from a box. */
const gap = ({ left, top, width, height }: Box, x: number, y: number) =>
  Math.hypot(Math.max(left - x, 0, x - left - width), Math.max(top - y, 0, y - top - height));

/** Points of a figure that do not crowd: on a jittered grid of cells of 70 by 66 pixels. */
const sparse = fc
  .uniqueArray(fc.integer({ min: 0, max: 59 }), { minLength: 1, maxLength: 14 })
  .chain((cells) =>
    fc.tuple(
      ...cells.map((cell) =>
        fc.record({
          x: fc.integer({ min: -14, max: 14 }).map((d) => 35 + 70 * (cell % 10) + d),
          y: fc.integer({ min: -14, max: 14 }).map((d) => 33 + 66 * Math.floor(cell / 10) + d),
          angle: fc.option(fc.double({ min: 0, max: 7, noNaN: true }), { nil: undefined }),
          width: fc.integer({ min: 8, max: 48 }),
        }),
      ),
    ),
  );

const lines = fc
  .array(fc.tuple(...[0, 1, 2, 3].map(() => fc.integer({ min: -50, max: 700 }))), { maxLength: 20 })
  .map((list) => list.flatMap((four) => [...four, 1]));

describe("labels of points that do not crowd", () => {
  test("all find a place, off handles, off each other, inside", () => {
    fc.assert(
      fc.property(sparse, lines, (points, drawn) => {
        const requests = points.map(({ x, y, angle, width }) =>
          request(x, y, {
            width,
            ...(angle === undefined ? {} : { toward: [Math.cos(angle), Math.sin(angle)] }),
          }),
        );
        const circles = points.map(({ x, y }) => handle(x, y));
        const placed = placeLabels(requests, { circles, lines: drawn }, BOUNDS);
        const boxes = placed.map((one) => one?.box);
        boxes.forEach((box, i) => {
          expect(box, `label ${i}`).toBeDefined();
          expect(box!.left).toBeGreaterThanOrEqual(0);
          expect(box!.top).toBeGreaterThanOrEqual(0);
          expect(box!.left + box!.width).toBeLessThanOrEqual(BOUNDS.width);
          expect(box!.top + box!.height).toBeLessThanOrEqual(BOUNDS.height);
          for (const { x, y } of points) expect(gap(box!, x, y)).toBeGreaterThanOrEqual(HANDLE);
          for (const other of boxes.slice(0, i)) expect(overlaps(box!, other!)).toBe(false);
        });
      }),
      { numRuns: 120 },
    );
  });

  test("the same question has the same answer", () => {
    fc.assert(
      fc.property(sparse, lines, (points, drawn) => {
        const requests = points.map(({ x, y }) => request(x, y));
        const obstacles = { circles: points.map(({ x, y }) => handle(x, y)), lines: drawn };
        expect(placeLabels(requests, obstacles, BOUNDS)).toEqual(placeLabels(requests, obstacles, BOUNDS));
      }),
      { numRuns: 30 },
    );
  });
});

test("however crowded: what is placed covers neither a handle nor another label", () => {
  const crowd = fc.array(fc.tuple(fc.integer({ min: 300, max: 400 }), fc.integer({ min: 150, max: 220 })), {
    minLength: 5,
    maxLength: 25,
  });
  fc.assert(
    fc.property(crowd, (points) => {
      const placed = placeLabels(
        points.map(([x, y]) => request(x, y)),
        { circles: points.map(([x, y]) => handle(x, y)), lines: [] },
        BOUNDS,
      );
      const boxes = placed.flatMap((one) => (one ? [one.box] : []));
      boxes.forEach((box, i) => {
        for (const [x, y] of points) expect(gap(box, x, y)).toBeGreaterThanOrEqual(HANDLE);
        for (const other of boxes.slice(0, i)) expect(overlaps(box, other)).toBe(false);
      });
    }),
    { numRuns: 60 },
  );
});

describe("a single label", () => {
  const middle = ({ left, top, width, height }: Box) => [left + width / 2, top + height / 2] as const;

  test("stands on the side it is sent to, whichever that is, just off its handle", () => {
    fc.assert(
      fc.property(fc.double({ min: 0, max: 2 * Math.PI, noNaN: true }), (angle) => {
        const toward = [Math.cos(angle), Math.sin(angle)];
        const { box } = placeLabels([request(350, 200, { toward })], EMPTY, BOUNDS)[0]!;
        const [x, y] = middle(box);
        expect((x - 350) * toward[0]! + (y - 200) * toward[1]!).toBeCloseTo(Math.hypot(x - 350, y - 200), 5);
        expect(gap(box, 350, 200)).toBeCloseTo(HANDLE + 3, 5);
      }),
    );
  });

  test("without a wish, to the upper right", () => {
    const [x, y] = middle(placeLabels([request(350, 200)], EMPTY, BOUNDS)[0]!.box);
    expect(x).toBeGreaterThan(350);
    expect(y).toBeLessThan(200);
  });

  test("keeps off the curve through its point, on its free side", () => {
    // A curve that comes from the right below, and legs above: free is the left.
    const drawn = [350, 200, 500, 320, 1, 350, 200, 420, 60, 1, 420, 60, 560, 60, 1];
    const { box, crossed } = placeLabels([request(350, 200)], { circles: [], lines: drawn }, BOUNDS)[0]!;
    expect(crossed).toBe(false);
    expect(middle(box)[0]).toBeLessThan(350);
  });

  test("turns away from a line where it was sent", () => {
    const drawn = [300, 180, 700, 180, 1];
    const sent = request(350, 200, { toward: [0, -1] });
    const { box, crossed } = placeLabels([sent], { circles: [], lines: drawn }, BOUNDS)[0]!;
    expect(crossed).toBe(false);
    expect(box.top > 180 || box.top + box.height < 180).toBe(true);
  });

  test("says that it is crossed where there is no way around", () => {
    const drawn = Array.from({ length: 60 }, (_, i) => [0, 7 * i, 700, 7 * i, 1]).flat();
    expect(placeLabels([request(350, 200)], { circles: [], lines: drawn }, BOUNDS)[0]!.crossed).toBe(true);
  });

  test("a fixed one stands on its point, and others keep off it", () => {
    const fixed = request(350, 200, { fixed: true, width: 60 });
    const [first, second] = placeLabels([fixed, request(350, 200, { clear: 2 })], EMPTY, BOUNDS);
    expect(middle(first!.box)).toEqual([350, 200]);
    expect(overlaps(first!.box, second!.box)).toBe(false);
  });

  test("is left out where there is no room at all", () => {
    expect(placeLabels([request(10, 10, { width: 90 })], EMPTY, { ...BOUNDS, width: 60 })).toEqual([null]);
  });

  test("those of a lower rank choose first", () => {
    const wish = { toward: [0, -1] } as const;
    const [late, early] = placeLabels(
      [request(350, 200, { ...wish, rank: 1 }), request(350, 200, { ...wish, rank: 0 })],
      EMPTY,
      BOUNDS,
    );
    expect(middle(early!.box)[0]).toBeCloseTo(350);
    expect(middle(late!.box)[0]).not.toBeCloseTo(350);
  });
});

test("a label slides as its point moves along a line: it hops rarely", () => {
  let hops = 0;
  let last: readonly number[] | null = null;
  for (let k = 0; k <= 200; k++) {
    const angle = (k / 200) * Math.PI;
    const [x, y] = [350 + 150 * Math.cos(angle), 250 - 150 * Math.sin(angle)];
    // The half circle itself, in straight pieces.
    const drawn = Array.from({ length: 40 }, (_, i) => {
      const [a, b] = [(i / 40) * Math.PI, ((i + 1) / 40) * Math.PI];
      return [
        350 + 150 * Math.cos(a),
        250 - 150 * Math.sin(a),
        350 + 150 * Math.cos(b),
        250 - 150 * Math.sin(b),
        1.6,
      ];
    }).flat();
    const { box } = placeLabels([request(x, y, { clear: 6 })], { circles: [], lines: drawn }, BOUNDS)[0]!;
    const offset = [box.left - x, box.top - y];
    if (last && Math.hypot(offset[0]! - last[0]!, offset[1]! - last[1]!) > 8) hops++;
    last = offset;
  }
  expect(hops).toBeLessThanOrEqual(4);
});
