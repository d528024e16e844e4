import type { Locator, Page } from "@playwright/test";
import { figureOf } from "../../../src/demo/figure.ts";
import type { Demo } from "../../../src/demo/index.ts";
import { changed, initialState } from "../../../src/demo/state.ts";
import { displayList } from "../../../src/render/display-list.ts";
import { stateOf } from "./figure.ts";

/** What the page did with WebGL, gathered from its very beginning. */
export interface GlWatch {
  contexts: WebGL2RenderingContext[];
  /** Bytes sent to buffers, and how many of them are indices of triangles. */
  bytes: number;
  indexBytes: number;
}

declare global {
  interface Window {
    glWatch: GlWatch;
    framesAsked: number;
  }
}

/** Watches WebGL and animation frames of all pages to come. */
export async function watchGl(page: Page): Promise<void> {
  await page.addInitScript(() => {
    window.glWatch = { contexts: [], bytes: 0, indexBytes: 0 };
    window.framesAsked = 0;
    const ask = window.requestAnimationFrame.bind(window);
    window.requestAnimationFrame = (callback) => {
      window.framesAsked += 1;
      return ask(callback);
    };
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...given: unknown[]) {
      const context = Reflect.apply(getContext, this, given);
      if (given[0] === "webgl2" && context && !window.glWatch.contexts.includes(context))
        window.glWatch.contexts.push(context);
      return context;
    } as typeof getContext;
    const gl = WebGL2RenderingContext.prototype;
    for (const name of ["bufferData", "bufferSubData"] as const) {
      const send = gl[name] as (...given: unknown[]) => void;
      (gl as unknown as Record<string, unknown>)[name] = function (this: unknown, ...given: unknown[]) {
        const data = given.find((one) => ArrayBuffer.isView(one)) as ArrayBufferView | undefined;
        window.glWatch.bytes += data?.byteLength ?? 0;
        if (given[0] === 0x8893) window.glWatch.indexBytes += data?.byteLength ?? 0;
        Reflect.apply(send, this, given);
      };
    }
  });
}

/** Bytes sent to the graphics card since the last time somebody asked. */
export function uploaded(page: Page): Promise<{ bytes: number; indexBytes: number }> {
  return page.evaluate(() => {
    const { bytes, indexBytes } = window.glWatch;
    window.glWatch.bytes = window.glWatch.indexBytes = 0;
    return { bytes, indexBytes };
  });
}

/** Waits until nothing moves any more: no frame is asked for in a while. */
export async function atRest(page: Page): Promise<void> {
  let before = -1;
  for (;;) {
    const now = await page.evaluate(() => window.framesAsked);
    if (now === before) return;
    before = now;
    await page.waitForTimeout(250);
  }
}

/** Colours of a figure's own canvas at places of its drawing, in pixels at scale 1. */
export function colours(
  figure: Locator,
  places: readonly (readonly number[])[],
): Promise<(readonly number[])[]> {
  return figure.evaluate((element, at) => {
    const shadow = element.shadowRoot!;
    const canvas = shadow.querySelector("canvas")!;
    const scale = Number(shadow.querySelector<HTMLElement>(".shell")!.style.getPropertyValue("--scale"));
    const ratio = (canvas.width / canvas.clientWidth) * scale;
    const context = canvas.getContext("2d")!;
    return at.map(([x, y]) => [
      ...context.getImageData(Math.round(x! * ratio - 0.5), Math.round(y! * ratio - 0.5), 1, 1).data,
    ]);
  }, places);
}

/** How the drawing of a figure on the page maps its views, worked out from its state and size. */
export async function drawingOf(figure: Locator, demo: Demo) {
  const size = await figure.evaluate((element) => {
    const shadow = element.shadowRoot!;
    const stage = shadow.querySelector<HTMLElement>(".stage")!;
    const scale = Number(shadow.querySelector<HTMLElement>(".shell")!.style.getPropertyValue("--scale"));
    return { width: stage.clientWidth / scale, height: stage.clientHeight / scale };
  });
  const state = changed(demo, initialState(demo), await stateOf(figure));
  const now = figureOf(demo, state);
  return displayList(now.views, now.scene, { ...size, lang: "en", facets: 0 });
}
