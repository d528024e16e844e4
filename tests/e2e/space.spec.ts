import { expect, type Locator, type Page, test } from "@playwright/test";
import bezierPatchDemo from "../../src/demos/bezier-patch.ts";
import { bezierPatch, surfaceCurvature, surfaceNormal } from "../../src/math/index.ts";
import { facetRgb } from "../../src/render/facet-colour.ts";
import { palettes } from "../../src/render/palette.ts";
import type { FacetColour } from "../../src/scene/marks.ts";
import { inPicture, litShare, normalColour, stripeShare, valueShare } from "../../src/scene/shade.ts";
import { alive, dragBy, hostPage, middleOf, stateOf } from "./support/figure.ts";
import { atRest, colours, drawingOf, uploaded, watchGl } from "./support/space.ts";

type Net = readonly (readonly (readonly number[])[])[];
const PATCH = "/embed/bezier-patch/?lang=en&theme=light";
/** A net whose sixteen points stand apart in each of the flat views. */
const APART = [0, 1, 2, 3]
  .map((i) =>
    [0, 1, 2, 3]
      .map((j) => {
        const [x, y] = [i - 1.5 + 0.2 * (j - 1.5), j - 1.5 + 0.2 * (i - 1.5)];
        return [x, y, 0.9 * Math.sin(1.7 * i + 2.3 * j)].map((value) => value.toFixed(2)).join(",");
      })
      .join(";"),
  )
  .join("/");
const handles = (figure: Locator) => figure.locator('[data-handle^="points."]');
const netOf = async (figure: Locator) => (await stateOf(figure)).points as Net;

test.beforeEach(({ page }) => watchGl(page));

/** The points that differ between two nets, as flat indices. */
function moved(before: Net, after: Net): number[] {
  const [a, b] = [before.flat(), after.flat()];
  return a.flatMap((point, k) => (point.every((x, axis) => x === b[k]![axis]) ? [] : [k]));
}

for (const [camera, kept] of [
  ["28,26,11", null],
  ["top", 2],
  ["front", 1],
  ["side", 0],
] as const) {
  test(`all sixteen points are dragged by mouse, seen from ${camera}`, async ({ page }) => {
    await page.setViewportSize({ width: 1100, height: 800 });
    await page.goto(`${PATCH}&camera=${camera}&points=${APART}`);
    const figure = await alive(page);
    for (let k = 0; k < 16; k++) {
      const before = await netOf(figure);
      const drawing = await drawingOf(figure, bezierPatchDemo);
      await dragBy(page, handles(figure).nth(k), 18, -12);
      const after = await netOf(figure);
      expect(moved(before, after), `point ${k}`).toEqual([k]);
      const [from, to] = [before.flat()[k]!, after.flat()[k]!];
      if (kept !== null) expect(to[kept]).toBe(from[kept]);
      const { space } = drawing.views.space!;
      const [p, q] = [space!.project(from), space!.project(to)];
      const scale = await figure.evaluate((e) =>
        Number(e.shadowRoot!.querySelector<HTMLElement>(".shell")!.style.getPropertyValue("--scale")),
      );
      const unit = scale * drawing.views.space!.scale[0]!;
      expect(q[0] - p[0]).toBeCloseTo(18 / unit, 1);
      expect(q[1] - p[1]).toBeCloseTo(12 / unit, 1);
      expect(q[2] - p[2]).toBeCloseTo(0, 1);
    }
  });

  test(`all sixteen points are moved by keys, seen from ${camera}`, async ({ page }) => {
    await page.goto(`${PATCH}&camera=${camera}&points=${APART}`);
    const figure = await alive(page);
    const { space } = (await drawingOf(figure, bezierPatchDemo)).views.space!;
    for (let k = 0; k < 16; k++) {
      for (const [key, direction] of [
        ["ArrowRight", [1, 0, 0]],
        ["ArrowUp", [0, 1, 0]],
        ["]", [0, 0, 1]],
      ] as const) {
        const before = await netOf(figure);
        await handles(figure).nth(k).focus();
        await page.keyboard.press(key);
        const after = await netOf(figure);
        expect(moved(before, after), `point ${k}, ${key}`).toEqual([k]);
        const [p, q] = [space!.project(before.flat()[k]!), space!.project(after.flat()[k]!)];
        const step = [0, 1, 2].map((axis) => q[axis]! - p[axis]!);
        for (let axis = 0; axis < 3; axis++) expect(step[axis]).toBeCloseTo(0.08 * direction[axis]!, 1);
      }
    }
  });
}

test.describe("with fingers", () => {
  test.use({ hasTouch: true });

  async function swipe(page: Page, from: { x: number; y: number }, dx: number, dy: number): Promise<void> {
    const session = await page.context().newCDPSession(page);
    const at = (share: number) => [{ x: from.x + dx * share, y: from.y + dy * share, id: 1 }];
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0) });
    for (const share of [0.25, 0.5, 0.75, 1]) {
      await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(share) });
    }
    await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await session.detach();
  }

  for (const camera of ["28,26,11", "top", "front", "side"]) {
    test(`all sixteen points are dragged, seen from ${camera}`, async ({ page }) => {
      await page.setViewportSize({ width: 1100, height: 800 });
      await page.goto(`${PATCH}&camera=${camera}&points=${APART}`);
      const figure = await alive(page);
      for (let k = 0; k < 16; k++) {
        const before = await netOf(figure);
        await swipe(page, await middleOf(handles(figure).nth(k)), 24, 16);
        expect(moved(before, await netOf(figure)), `point ${k}`).toEqual([k]);
      }
    });
  }

  test("a finger scrolls the page until the figure is entered; then one turns and two zoom", async ({
    page,
  }) => {
    await page.goto(`${PATCH}&net=0`);
    const figure = await alive(page);
    const stage = await figure.locator(".orbit").boundingBox();
    const empty = { x: stage!.x + 120, y: stage!.y + stage!.height - 60 };
    const camera = async () => (await stateOf(figure)).camera as readonly number[];
    const start = await camera();
    await swipe(page, empty, 60, 0);
    expect(await camera()).toEqual(start);
    await page.touchscreen.tap(empty.x, empty.y);
    await expect(figure.locator(".stage.is-entered")).toHaveCount(1);
    await swipe(page, empty, 60, 0);
    await atRest(page);
    const turned = await camera();
    expect(turned[0]).toBeLessThan(start[0]! - 5);
    expect(turned[2]).toBe(start[2]);
    const session = await page.context().newCDPSession(page);
    const two = (apart: number) =>
      [-1, 1].map((side, id) => ({ x: empty.x + 100 + side * apart, y: empty.y, id }));
    await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: two(30) });
    for (const apart of [40, 50, 60]) {
      await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: two(apart) });
    }
    await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    expect((await camera())[2]).toBeLessThan(start[2]! * 0.7);
    await figure.locator(".orbit").press("Escape");
    await expect(figure.locator(".stage.is-entered")).toHaveCount(0);
  });
});

test("the surface follows the hand in the same frame", async ({ page }) => {
  await page.goto(`${PATCH}&net=0`);
  const figure = await alive(page);
  await atRest(page);
  const differs = await figure.evaluate(async (element) => {
    const shadow = element.shadowRoot!;
    const canvas = shadow.querySelector("canvas")!;
    const picture = () =>
      canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height).data.join();
    const handle = shadow.querySelector<HTMLElement>('[data-handle="points.5"]')!;
    const box = handle.getBoundingClientRect();
    const send = (type: string, by: number) =>
      handle.dispatchEvent(
        new PointerEvent(type, {
          bubbles: true,
          composed: true,
          pointerId: 7,
          button: 0,
          clientX: box.x + box.width / 2,
          clientY: box.y + box.height / 2 + by,
        }),
      );
    const before = picture();
    send("pointerdown", 0);
    send("pointermove", 60);
    await new Promise(requestAnimationFrame);
    const after = picture();
    send("pointerup", 60);
    return before !== after;
  });
  expect(differs).toBe(true);
});

test("only what has changed is sent to the graphics card", async ({ page }) => {
  await page.goto(PATCH);
  const figure = await alive(page);
  await expect.poll(() => page.evaluate(() => window.glWatch.bytes)).toBeGreaterThan(0);
  await atRest(page);
  await uploaded(page);
  // Turning the view: nothing but a few numbers that are no buffers.
  await figure.locator(".orbit").press("ArrowLeft");
  await atRest(page);
  expect(await uploaded(page)).toEqual({ bytes: 0, indexBytes: 0 });
  // Another colour: nothing either; curvatures: their values alone, one a sample.
  const setState = (state: object) =>
    figure.evaluate((e, s) => (e as unknown as { setState(s: object): void }).setState(s), state);
  await setState({ shading: "stripes" });
  await atRest(page);
  expect((await uploaded(page)).bytes).toBe(0);
  await setState({ shading: "curvature" });
  await atRest(page);
  expect((await uploaded(page)).bytes).toBe(25 * 25 * 4);
  // One key moves a point: positions and normals and values, once, and no triangles.
  await handles(figure).nth(5).press("ArrowUp");
  await atRest(page);
  expect(await uploaded(page)).toEqual({ bytes: 25 * 25 * 4 * 7, indexBytes: 0 });
});

test("another patch of the teapot, another view: its 32 patches stay where they are", async ({ page }) => {
  await page.goto("/embed/teapot/?lang=en");
  const figure = await alive(page);
  await expect.poll(() => page.evaluate(() => window.glWatch.bytes)).toBeGreaterThan(0);
  await atRest(page);
  await uploaded(page);
  await figure.locator(".main-slider input").press("ArrowRight");
  await figure.locator(".orbit").press("ArrowLeft");
  await atRest(page);
  expect((await uploaded(page)).bytes).toBe(0);
});

const SHADINGS = ["lit", "normals", "curvature", "stripes"] as const;

for (const theme of ["light", "dark"] as const) {
  for (const shading of SHADINGS) {
    test(`${shading} in ${theme}: the pixels have the colours of the formulas`, async ({ page }) => {
      await page.setViewportSize({ width: 1000, height: 760 });
      await page.goto(
        `/embed/bezier-patch/?lang=en&theme=${theme}&net=0&uv=0,0&camera=20,55,7&shading=${shading}&dpr=2`,
      );
      const figure = await alive(page);
      await expect.poll(() => page.evaluate(() => window.glWatch.bytes)).toBeGreaterThan(0);
      await atRest(page);
      const net = await netOf(figure);
      const surface = bezierPatch(net);
      const { views, primitives } = await drawingOf(figure, bezierPatchDemo);
      const view = views.space!;
      const { axes } = view.space!;
      const discs = primitives.filter((one) => one.kind === "circle");
      const tests = [4, 8, 10, 14, 16, 20].flatMap((i) =>
        [4, 10, 13, 20].map((j) => {
          const [u, v] = [i / 24, j / 24];
          const normal = surfaceNormal(surface, u, v)!;
          const seen = inPicture(normal, axes);
          const colour: FacetColour =
            shading === "lit"
              ? { between: "front", share: litShare(seen) }
              : shading === "stripes"
                ? { between: "stripes", share: stripeShare(seen) }
                : shading === "normals"
                  ? { rgb: normalColour(normal) }
                  : {
                      map: "diverging",
                      share: valueShare(surfaceCurvature(surface, u, v)!.gaussian, [-1, 1]),
                    };
          return {
            at: view.toPixel(surface.point(u, v)),
            facing: seen[2],
            rgb: facetRgb(colour, palettes[theme]),
          };
        }),
      );
      const found = await colours(
        figure,
        tests.map(({ at }) => at),
      );
      // A pixel is not exactly the sample: where the colour runs steeply it may be a little off.
      const allowed = shading === "stripes" ? 24 : shading === "curvature" ? 12 : 5;
      let close = 0;
      tests.forEach(({ rgb, facing }, k) => {
        const [x, y] = tests[k]!.at;
        const covered = discs.some(({ at, radius }) => Math.hypot(at[0]! - x, at[1]! - y) < radius + 3);
        if (covered || facing < 0.35) return; // below a point, or seen at a slant
        const off = Math.max(...rgb.map((x, channel) => Math.abs(x - found[k]![channel]!)));
        expect(off, `place ${k}: ${rgb} drawn as ${found[k]}`).toBeLessThanOrEqual(allowed);
        close += 1;
      });
      expect(close).toBeGreaterThan(15);
    });
  }
}

test("after the graphics card is lost and comes back, state and pixels are the same", async ({ page }) => {
  await page.goto(`${PATCH}&net=0`);
  const figure = await alive(page);
  await expect.poll(() => page.evaluate(() => window.glWatch.bytes)).toBeGreaterThan(0);
  await atRest(page);
  const view = (await drawingOf(figure, bezierPatchDemo)).views.space!;
  const surface = bezierPatch(await netOf(figure));
  const places = [0.2, 0.45, 0.8].map((t) => view.toPixel(surface.point(t, 0.55)));
  const [state, pixels] = [await stateOf(figure), await colours(figure, places)];
  const extension = (call: "loseContext" | "restoreContext") =>
    page.evaluate((name) => {
      const holder = window as unknown as { lose?: WEBGL_lose_context };
      holder.lose ??= window.glWatch.contexts[0]!.getExtension("WEBGL_lose_context")!;
      holder.lose[name]();
    }, call);

  await extension("loseContext");
  await atRest(page);
  const bridge = await colours(figure, places);
  bridge.forEach((colour, k) => {
    // Facets are flat: near the same colour, and there at all.
    expect(colour[3]).toBe(255);
    for (let c = 0; c < 3; c++) expect(Math.abs(colour[c]! - pixels[k]![c]!)).toBeLessThan(40);
  });
  expect(await stateOf(figure)).toEqual(state);
  await dragBy(page, handles(figure).nth(5), 30, 20);
  expect(moved(state.points as Net, await netOf(figure))).toEqual([5]);
  await page.keyboard.press("Control+z");

  await extension("restoreContext");
  await atRest(page);
  expect(await stateOf(figure)).toEqual(state);
  expect(await colours(figure, places)).toEqual(pixels);
});

test("twenty figures of space on one page share one context, and none is blank", async ({ page }) => {
  const figures = Array.from({ length: 20 }, (_, k) => {
    const demo = ["bezier-patch", "teapot", "surface-tangents", "tensor-product", "parametric-surface"][
      k % 5
    ];
    return `<curve-demo demo="${demo}" style="width:360px" camera="${20 + 3 * k},30,9"></curve-demo>`;
  });
  await hostPage(page, `<script type="module" src="/embed.js"></script>${figures.join("")}`);
  for (let k = 0; k < 20; k++) {
    const figure = page.locator("curve-demo").nth(k);
    await figure.scrollIntoViewIfNeeded();
    await expect(figure).toHaveAttribute("data-ready", "");
  }
  await expect.poll(() => page.evaluate(() => window.glWatch.contexts.length)).toBe(1);
  await atRest(page);
  for (let k = 0; k < 20; k++) {
    const share = await page
      .locator("curve-demo")
      .nth(k)
      .evaluate((element) => {
        const canvas = element.shadowRoot!.querySelector("canvas")!;
        const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
        let full = 0;
        for (let i = 3; i < data.length; i += 4) if (data[i] === 255) full++;
        return full / (data.length / 4);
      });
    expect(share, `figure ${k}`).toBeGreaterThan(0.05);
  }
  expect(await page.evaluate(() => window.glWatch.contexts.length)).toBe(1);
});

test("a page without space loads nothing of it", async ({ page }) => {
  const asked: string[] = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto("/embed/bezier-curve/?lang=en");
  await alive(page);
  await page.waitForLoadState("networkidle");
  expect(asked.filter((url) => /three|space/.test(url))).toEqual([]);
  expect(await page.evaluate(() => window.glWatch.contexts.length)).toBe(0);
});

test("the view turns by mouse, coasts to rest, zooms with Ctrl alone, and goes back by a double click", async ({
  page,
}) => {
  await page.goto(`${PATCH}&net=0`);
  const figure = await alive(page);
  const box = (await figure.locator(".orbit").boundingBox())!;
  const empty = { x: box.x + 130, y: box.y + box.height - 70 };
  const camera = async () => (await stateOf(figure)).camera as readonly number[];
  const start = await camera();
  await page.mouse.move(empty.x, empty.y);
  await page.mouse.wheel(0, 200);
  await atRest(page);
  expect(await camera()).toEqual(start);
  await page.mouse.down();
  await page.mouse.move(empty.x + 80, empty.y - 30, { steps: 5 });
  await page.mouse.up();
  await atRest(page);
  const turned = await camera();
  expect(turned[0]).toBeLessThan(start[0]! - 10);
  expect(turned[1]).toBeLessThan(start[1]! - 3);
  const frames = await page.evaluate(() => window.framesAsked);
  await page.waitForTimeout(600);
  expect(await page.evaluate(() => window.framesAsked)).toBe(frames);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -200);
  await page.keyboard.up("Control");
  await atRest(page);
  expect((await camera())[2]).toBeLessThan(start[2]!);
  await page.mouse.dblclick(empty.x, empty.y);
  await atRest(page);
  expect(await camera()).toEqual(start);
  await figure.locator(".tool-undo").click();
  expect(await camera()).not.toEqual(start);
});

test("the view turns by keys and buttons, and is said in words", async ({ page }) => {
  await page.goto(PATCH);
  const figure = await alive(page);
  const camera = async () => (await stateOf(figure)).camera as readonly number[];
  const [yaw, pitch, distance] = await camera();
  const pad = figure.locator(".orbit");
  await pad.press("ArrowLeft");
  await pad.press("ArrowDown");
  await pad.press("+");
  const [nextYaw, nextPitch, nextDistance] = await camera();
  expect([nextYaw! - yaw!, nextPitch! - pitch!]).toEqual([5, 5]);
  expect(nextDistance).toBeLessThan(distance!);
  for (const [name, said] of [
    ["top", "Seen from above: x to the right, y up."],
    ["front", "Seen from the front: x to the right, z up."],
    ["side", "Seen from the right: y to the right, z up."],
  ] as const) {
    await figure.locator(`.views [data-view="${name}"]`).click();
    await expect(figure.locator(".description")).toContainText(said);
    await expect(figure.locator(`.views [aria-pressed="true"]`)).toHaveText(name);
    await expect(pad).toHaveAttribute("aria-label", `Turn the view. ${said}`);
  }
  await figure.locator('.views [data-view="free"]').click();
  await expect.poll(async () => (await camera())[0]).toBeCloseTo(nextYaw!, 6);
});

test("the camera stands in the address and in attributes", async ({ page }) => {
  await page.goto(`${PATCH}&camera=top`);
  expect((await stateOf(await alive(page))).camera).toEqual([0, 90, 8]);
  await page.goto(`${PATCH}&camera=nowhere`);
  const figure = await alive(page);
  expect((await stateOf(figure)).camera).toEqual([28, 26, 8]);
  await expect(figure.locator(".problems")).toContainText("camera = nowhere");
  await hostPage(
    page,
    '<script type="module" src="/embed.js"></script><curve-demo demo="bezier-patch" camera="10,20,6"></curve-demo>',
  );
  expect((await stateOf(await alive(page))).camera).toEqual([10, 20, 6]);
});

test("where the tangents span no plane, the figure says so and draws no normal", async ({ page }) => {
  for (const [address, sentence] of [
    ["surface-tangents/?lang=en&state=tip", "Their cross product vanishes: there is no normal here."],
    ["surface-tangents/?lang=en&state=corner", "Their cross product vanishes: there is no normal here."],
    [
      "teapot/?lang=en&state=lid",
      "there the cross product of the derivatives vanishes, and there is no normal.",
    ],
  ] as const) {
    await page.goto(`/embed/${address}`);
    const figure = await alive(page);
    await expect(figure.locator(".description")).toContainText(sentence);
    await expect(figure.locator(".readout")).toContainText(/n\s*=\s*–/);
  }
});

test("on paper the surface is a vector picture of the present state", async ({ page }) => {
  await page.goto("/embed/teapot/?lang=en&show=part&patch=3");
  const figure = await alive(page);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const facets = figure.locator(":scope > svg .facets path");
  expect(await facets.count()).toBeGreaterThan(100);
  await expect(figure.locator(":scope > svg")).toHaveAttribute("aria-label", /Patch 3 is highlighted/);
});

test("a figure in forced colours is drawn with them", async ({ page }) => {
  await page.emulateMedia({ forcedColors: "active" });
  await page.goto(`${PATCH}&net=0`);
  const figure = await alive(page);
  await atRest(page);
  const view = (await drawingOf(figure, bezierPatchDemo)).views.space!;
  const surface = bezierPatch(await netOf(figure));
  const [colour] = await colours(figure, [view.toPixel(surface.point(0.3, 0.6))]);
  const system = await page.evaluate(() =>
    ["GrayText", "Canvas"].map((name) => {
      const probe = document.createElement("span");
      probe.style.color = name;
      document.body.append(probe);
      return getComputedStyle(probe).color.match(/\d+/g)!.map(Number);
    }),
  );
  // Between two of the system's colours, and not one of ours.
  for (let k = 0; k < 3; k++) {
    const [low, high] = system.map((one) => one[k]!).sort((a, b) => a - b) as [number, number];
    expect(colour![k]).toBeGreaterThanOrEqual(low - 2);
    expect(colour![k]).toBeLessThanOrEqual(high + 2);
  }
});
