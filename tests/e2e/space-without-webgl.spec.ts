import { expect, test } from "@playwright/test";
import { alive, dragBy, stateOf } from "./support/figure.ts";
import { atRest, watchGl } from "./support/space.ts";

const { path, env } = JSON.parse(process.env.STRAKLATTE_TEST_BROWSER!) as {
  path: string;
  env: Record<string, string>;
};

// A browser that was started without any WebGL.
test.use({
  launchOptions: {
    executablePath: path,
    env: { ...process.env, ...env } as Record<string, string>,
    args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis"],
  },
});
test.beforeEach(({ page }) => watchGl(page));

const DEMOS = [
  ["bezier-patch", "points.6"],
  ["tensor-product", "points.6"],
  ["teapot", "uv.0"],
  ["surface-tangents", "uv.0"],
  ["parametric-surface", "uv.0"],
] as const;

for (const [id, handle] of DEMOS) {
  test(`${id} is there, is dragged and turned`, async ({ page }) => {
    await page.goto(`/embed/${id}/?lang=en&theme=light`);
    const figure = await alive(page);
    expect(await page.evaluate(() => document.createElement("canvas").getContext("webgl2"))).toBeNull();
    await atRest(page);
    const picture = () =>
      figure.evaluate((element) => {
        const canvas = element.shadowRoot!.querySelector("canvas")!;
        const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
        let [full, sum] = [0, 0];
        for (let i = 0; i < data.length; i += 4) {
          if (data[i + 3] === 255) full++;
          sum = (sum * 31 + data[i]! + data[i + 1]!) % 1_000_003;
        }
        return { share: full / (data.length / 4), sum };
      });
    const first = await picture();
    expect(first.share).toBeGreaterThan(0.05);
    const [param] = handle.split(".");
    const before = (await stateOf(figure))[param!];
    await dragBy(page, figure.locator(`[data-handle="${handle}"]`), -25, 20);
    await atRest(page);
    expect((await stateOf(figure))[param!]).not.toEqual(before);
    const second = await picture();
    expect(second.sum).not.toBe(first.sum);
    await figure.locator(".orbit").press("ArrowRight");
    await atRest(page);
    expect((await picture()).sum).not.toBe(second.sum);
    expect(await figure.locator(".problems").textContent()).toBe("");
  });
}
