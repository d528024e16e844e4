import { expect, type Locator, type Page, test } from "@playwright/test";
import { compileLesson } from "../../src/build/compile-lesson.ts";
import { still } from "../../src/build/still.ts";
import basisDemo from "../../src/demos/bezier-curve.ts";
import { deCasteljau } from "../../src/math/index.ts";
import { formatNumber, formatPoint } from "../../src/words/numbers.ts";
import { dragBy, middleOf, stateOf } from "./support/figure.ts";

interface LivingDemo extends HTMLElement {
  readonly names: readonly string[];
  readonly values: Record<string, unknown>;
  setState(state: Record<string, unknown>): void;
}

/** The figure of an id, alive and in sight. */
async function figure(page: Page, id: string): Promise<Locator> {
  const demo = page.locator(`#${id} curve-demo`);
  await page
    .locator(`#${id}`)
    .evaluate((element) => element.scrollIntoView({ block: "center", behavior: "instant" }));
  await page.locator(`#${id} curve-demo[data-ready]`).waitFor();
  return demo;
}
const lit = (page: Page, within: string) =>
  page
    .locator(`${within} .katex-html .is-lit`)
    .evaluateAll((all) => all.map((one) => (one as HTMLElement).dataset.tie));

/** Notes which names a figure is asked to light. */
async function noteLight(demo: Locator): Promise<() => Promise<string[]>> {
  await demo.evaluate((element) => {
    const target = element as HTMLElement & { light(names: Iterable<string>): void; asked?: string[] };
    const light = target.light.bind(target);
    target.light = (names) => {
      target.asked = [...names];
      light(names);
    };
  });
  return () => demo.evaluate((element) => (element as HTMLElement & { asked?: string[] }).asked ?? []);
}
/** How the picture looks: a light changes it. */
const pixels = (demo: Locator) =>
  demo.evaluate(
    (element) =>
      new Promise<string>((resolve) =>
        requestAnimationFrame(() =>
          requestAnimationFrame(() => resolve(element.shadowRoot!.querySelector("canvas")!.toDataURL())),
        ),
      ),
  );

test.describe("formula and picture of the lesson on Bézier curves", () => {
  test("every c_i, B_i^n, t and p(t) in a displayed formula is tied to a figure of the lesson that has it", async ({
    page,
  }) => {
    await page.goto("de/bezier/");
    const loose = await page.evaluate(() => {
      const wanted = new Map<string, string>();
      for (const row of document.querySelectorAll(".symbols dl > div")) {
        const tex = row.querySelector("dt annotation")!.textContent!;
        if (["c_i", "B_i^n", "t", "p(t)"].includes(tex)) wanted.set(row.id.replace("symbol-", ""), tex);
      }
      const seen = new Map<string, number>();
      const untied: string[] = [];
      for (const symbol of document.querySelectorAll<HTMLElement>(".formula .katex-html [data-symbol]")) {
        const tex = wanted.get(symbol.dataset.symbol!);
        if (tex === undefined) continue;
        seen.set(tex, (seen.get(tex) ?? 0) + 1);
        const tie = symbol.dataset.tie;
        if (!tie || !document.getElementById(tie.split("/")[0]!)?.querySelector("curve-demo"))
          untied.push(`${symbol.textContent} in ${symbol.closest("[id]")?.id}`);
      }
      return { untied, seen: [...seen] };
    });
    const seen = new Map(loose.seen);
    for (const tex of ["c_i", "B_i^n", "t", "p(t)"]) expect(seen.get(tex), tex).toBeGreaterThan(1);
    // Of another degree than the figure's, nothing can be shown.
    expect(loose.untied.filter((text) => !/^B.*n−1/.test(text.replace(/\u200b/g, "")))).toEqual([]);
  });

  test("pointing at any tied symbol of a displayed formula lights something that the figure shows", async ({
    page,
  }) => {
    test.setTimeout(90_000);
    await page.goto("en/bezier/");
    const ids = await page
      .locator(".formula [data-tie]")
      .evaluateAll((all) => [...new Set(all.map((one) => (one as HTMLElement).dataset.tie!.split("/")[0]!))]);
    expect(ids.length).toBeGreaterThan(5);
    for (const id of ids) {
      const demo = await figure(page, id);
      const asked = await noteLight(demo);
      const dark = await page.evaluate(
        async ({ id }) => {
          const demo = document.querySelector(`#${id} curve-demo`) as HTMLElement & {
            names: readonly string[];
            asked?: string[];
          };
          const missed: string[] = [];
          const main = document.querySelector("main")!;
          const symbols = document.querySelectorAll<HTMLElement>(`.formula [data-tie^="${id}/"]`);
          for (const symbol of symbols) {
            main.dispatchEvent(new PointerEvent("pointerleave"));
            demo.asked = [];
            symbol.dispatchEvent(new PointerEvent("pointerover", { bubbles: true, pointerType: "mouse" }));
            const shown = demo.asked.filter((name) => demo.names.includes(name));
            // A point that only another state of the figure has is not there to be lit.
            if (shown.length === 0 && !/points\.\d|derivative/.test(symbol.dataset.tie!))
              missed.push(symbol.dataset.tie!);
            if (!symbol.classList.contains("is-lit") && shown.length > 0)
              missed.push(`not lit: ${symbol.dataset.tie}`);
          }
          main.dispatchEvent(new PointerEvent("pointerleave"));
          return missed;
        },
        { id },
      );
      expect(dark, id).toEqual([]);
      expect(await asked()).toEqual([]);
    }
  });

  test("symbol → mark: the picture changes; mark → symbol: hover, focus and drag of the handle, hover of a mark", async ({
    page,
  }) => {
    await page.goto("de/bezier/");
    const demo = await figure(page, "fig-weights");
    const calm = await pixels(demo);
    const symbol = page.locator('#eq-cubic [data-tie="fig-weights/points.2"]').first();
    await symbol.evaluate((element) => element.scrollIntoView({ block: "start", behavior: "instant" }));
    await symbol.hover();
    await expect.poll(() => pixels(demo)).not.toBe(calm);
    expect(await lit(page, "#eq-cubic")).toEqual(["fig-weights/points.2"]);
    await page.mouse.move(5, 5);
    await expect.poll(() => pixels(demo)).toBe(calm);
    expect(await lit(page, "#eq-cubic")).toEqual([]);

    await figure(page, "fig-weights");
    const handle = demo.locator('[data-handle="points.1"]');
    await handle.hover();
    await expect.poll(() => lit(page, "#eq-cubic")).toEqual(["fig-weights/points.1"]);
    await page.mouse.move(5, 5);
    await expect.poll(() => lit(page, "#eq-cubic")).toEqual([]);
    await handle.focus();
    await expect.poll(() => lit(page, "#eq-cubic")).toEqual(["fig-weights/points.1"]);
    await demo.locator("input[type=range]").focus();
    await expect.poll(async () => new Set(await lit(page, "#eq-cubic"))).toEqual(new Set(["fig-weights/t"]));
    await handle.evaluate((element) => element.blur());

    // A drag, wherever the pointer is on the way.
    const { x, y } = await middleOf(demo.locator('[data-handle="points.3"]'));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 60, y - 40, { steps: 4 });
    expect(await lit(page, "#eq-cubic")).toEqual(["fig-weights/points.3"]);
    await page.mouse.up();
    await demo.locator('[data-handle="points.3"]').evaluate((element) => element.blur());

    // The curve point is no handle, but it has a name.
    await demo.evaluate((element) => (element as LivingDemo).setState({ t: 0.5 }));
    const stage = await demo.locator(".stage").boundingBox();
    const values = await demo.evaluate((element) => (element as LivingDemo).values);
    const [a, b] = await Promise.all(
      ["points.0", "points.2"].map((id) => middleOf(demo.locator(`[data-handle="${id}"]`))),
    );
    const [c0, , c2] = values.points as number[][];
    const [px, py] = values.p as number[];
    expect(stage).not.toBeNull();
    const at = (k: 0 | 1, value: number) => {
      const [from, to] = k === 0 ? [a!.x, b!.x] : [a!.y, b!.y];
      return from + ((to - from) * (value - c0![k]!)) / (c2![k]! - c0![k]!);
    };
    await page.mouse.move(at(0, px!), at(1, py!));
    await expect.poll(() => lit(page, "#eq-cubic")).toEqual(["fig-weights/p"]);
  });

  test("symbols carry the index colour of the figure, in text, formula, light and dark, and its shape", async ({
    page,
  }) => {
    for (const scheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme: scheme });
      await page.goto("de/bezier/");
      const demo = await figure(page, "fig-weights");
      const inFigure = await demo
        .locator('[data-handle="points.1"]')
        .evaluate((element) => getComputedStyle(element).color);
      const looks = await page
        .locator('[data-tie="fig-weights/points.1"]')
        .evaluateAll((all) => [...new Set(all.map((one) => getComputedStyle(one).color))]);
      expect(looks).toEqual([inFigure]);
    }
    const shapes = await page.evaluate(() =>
      [0, 1, 2, 3].map((i) => {
        const symbol = document.querySelector(`#eq-cubic [data-tie="fig-weights/points.${i}"]`)!;
        return getComputedStyle(symbol, "::after").clipPath;
      }),
    );
    expect(new Set(shapes).size).toBe(4);
    await page.emulateMedia({ media: "print" });
    const printed = await page
      .locator('#eq-cubic [data-tie="fig-weights/points.1"]')
      .first()
      .evaluate((element) => getComputedStyle(element, "::after").clipPath);
    expect(printed).toBe(shapes[1]);
  });
});

test("every c_ij, S_u, S_v and n in a displayed formula of the lesson on surfaces is tied, and lights what is shown", async ({
  page,
}) => {
  await page.goto("en/surfaces/");
  const symbols = await page.evaluate(() => {
    const entries = new Map<string, string>();
    for (const row of document.querySelectorAll(".symbols dl > div"))
      entries.set(row.id.replace("symbol-", ""), row.querySelector("dt annotation")!.textContent!);
    return [...document.querySelectorAll<HTMLElement>(".formula .katex-html [data-symbol]")].map((symbol) => [
      entries.get(symbol.dataset.symbol!) ?? "",
      symbol.dataset.tie ?? null,
    ]);
  });
  for (const tex of ["c_{ij}", "S_u", "S_v"]) {
    const found = symbols.filter(([symbol]) => symbol === tex);
    expect(found.length, tex).toBeGreaterThan(1);
    expect(found.filter(([, tie]) => tie === null)).toEqual([]);
  }
  const normal = page.locator('#eq-normal [data-tie="fig-tangents/normal"]').first();
  const demo = await figure(page, "fig-tangents");
  const asked = await noteLight(demo);
  const names = await demo.evaluate((element) => (element as LivingDemo).names);
  for (const [symbol, name] of [
    [normal, "normal"],
    [page.locator('#eq-normal [data-tie="fig-tangents/su"]').first(), "su"],
    [page.locator('#eq-normal [data-tie="fig-tangents/sv"]').first(), "sv"],
  ] as const) {
    await symbol.dispatchEvent("pointerover", { bubbles: true, pointerType: "mouse" });
    expect(await asked()).toEqual([name]);
    expect(names).toContain(name);
  }
  const patch = await figure(page, "fig-patch");
  await patch.locator('[data-handle="points.5"]').focus();
  // All c_ij of its formula, whichever they are, mean this one as well.
  await expect.poll(async () => (await lit(page, "#eq-bicubic")).length).toBeGreaterThan(0);
});

test("the live triangle shows the numbers of de Casteljau, in both languages, for the ears after the drag", async ({
  page,
}) => {
  for (const lang of ["de", "en"] as const) {
    await page.goto(`${lang}/bezier/`);
    const demo = await figure(page, "fig-construction");
    const shown = (selector: string) =>
      page.locator(`#eq-live ${selector}`).evaluateAll((all) => all.map((one) => one.textContent));
    const expected = async () => {
      const { points, t } = (await stateOf(demo)) as { points: number[][]; t: number };
      const b = deCasteljau(points, t);
      return [0, 1, 2, 3].flatMap((k) =>
        Array.from({ length: k + 1 }, (_, r) => formatPoint(b[r]![k - r]!, lang, 2, true)),
      );
    };
    // KaTeX sets a matrix column by column; MathML row by row.
    expect((await shown(".katex-html .live")).sort()).toEqual((await expected()).sort());
    await dragBy(page, demo.locator('[data-handle="points.1"]'), 37, 21);
    const after = await expected();
    await page
      .locator("#eq-live")
      .evaluate((element) => element.scrollIntoView({ block: "end", behavior: "instant" }));
    await expect.poll(async () => (await shown(".katex-html .live")).sort()).toEqual([...after].sort());
    expect(await shown("mn[data-live]")).toEqual(after);
    const numbers = await page.locator("#eq-cubic mn[data-live]").allTextContents();
    expect(numbers).toEqual(
      [0.216, 0.432, 0.288, 0.064].map((weight) => formatNumber(weight, lang, 3, true)),
    );
  }
});

test("live numbers do not move what stands around them", async ({ page }) => {
  await page.goto("de/bezier/");
  const demo = await figure(page, "fig-weights");
  const width = () =>
    page
      .locator("#eq-cubic .katex-base")
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().width));
  const before = await width();
  for (const t of [0, 0.03, 0.5, 0.97, 1]) {
    await demo.evaluate((element, t) => (element as LivingDemo).setState({ t }), t);
    await expect
      .poll(() => page.locator("#eq-cubic mn[data-live]").first().textContent())
      .toBe(formatNumber((1 - t) ** 3, "de", 3, true));
    expect(await width()).toEqual(before);
  }
});

test("keys: the button after a formula lists its symbols with meaning and value; what has the focus lights up", async ({
  page,
}) => {
  await page.goto("en/bezier/");
  const demo = await figure(page, "fig-weights");
  const asked = await noteLight(demo);
  const button = page.locator("#eq-cubic .symbols-button");
  await button.focus();
  await page.keyboard.press("Enter");
  const list = page.getByRole("listbox", { name: "Symbols of this formula" });
  await expect(list).toBeVisible();
  await expect(button).toHaveAttribute("aria-expanded", "true");
  const options = list.getByRole("option");
  await expect(options.first()).toBeFocused();
  await expect(options.first()).toHaveAccessibleName(/^p\(t\): curve point.*= \(1\.62, 1\.79\)/);
  expect(await asked()).toEqual(["p"]);
  await page.keyboard.press("ArrowDown");
  await expect(options.nth(1)).toHaveAccessibleName(/^t: parameter of the curve.*= 0\.4/);
  expect(await asked()).toEqual(["t"]);
  await expect(demo.locator(".main-slider")).toHaveClass(/is-lit/);
  await page.keyboard.press("End");
  await expect(options.last()).toHaveAccessibleName(/^c 3: control point/);
  expect(await asked()).toEqual(["points.3"]);
  await page.keyboard.press("Escape");
  await expect(list).toHaveCount(0);
  await expect(button).toBeFocused();
  expect(await asked()).toEqual([]);
  // Where but numbers stand in the formula, the list says what they are.
  await figure(page, "fig-construction");
  await page.locator("#eq-live .symbols-button").focus();
  await page.keyboard.press("Enter");
  const numbers = page.getByRole("option");
  await expect(numbers.nth(1)).toHaveAccessibleName(/^c 1: control point.*= \(0\.9, 2\.3\)/);
  await expect(numbers.nth(2)).toHaveAccessibleName(/^b 0 1: point number.*= \(0\.36, 0\.92\)/);
  await page.keyboard.press("Escape");
  // Within the formula, nothing takes the focus.
  expect(await page.locator(".formula:not([tabindex]) :is([tabindex], button, a)").count()).toBe(0);
});

test("resting on a symbol tells its meaning; Escape takes it away; a tap tells it too", async ({ page }) => {
  await page.goto("en/bezier/");
  const symbol = page.locator("#eq-bernstein [data-symbol]").first();
  await symbol.scrollIntoViewIfNeeded();
  const tip = page.locator(".symbol-tip");
  await symbol.hover();
  await expect(tip).toBeVisible();
  await expect(tip).toContainText("Bernstein polynomial of degree");
  await page.keyboard.press("Escape");
  await expect(tip).toBeHidden();
  await symbol.click();
  await expect(tip).toBeVisible();
  await page.locator("h1").click();
  await expect(tip).toBeHidden();
});

test.describe("state links", () => {
  test("glide, show that the figure is in their state, and undo takes them back", async ({ page }) => {
    await page.goto("en/bezier/");
    const demo = await figure(page, "fig-curve");
    const before = await stateOf(demo);
    const link = page.locator('a.state-link[href^="#fig-curve?"]').first();
    await link.scrollIntoViewIfNeeded();
    const frames = await link.evaluate(async (element) => {
      const demo = document.querySelector("#fig-curve curve-demo")!;
      const seen: { committed: boolean; time: number }[] = [];
      demo.addEventListener("statechange", (event) =>
        seen.push({ committed: (event as CustomEvent).detail.committed, time: performance.now() }),
      );
      const start = performance.now();
      (element as HTMLElement).click();
      while (!seen.some((one) => one.committed) && performance.now() - start < 3000)
        await new Promise((resolve) => setTimeout(resolve, 10));
      return seen.map(({ committed, time }) => ({ committed, time: time - start }));
    });
    expect(frames.filter(({ committed }) => !committed).length).toBeGreaterThan(2);
    expect(frames.at(-1)!.committed).toBe(true);
    expect(frames.at(-1)!.time).toBeGreaterThan(200);
    await expect(link).toHaveAttribute("aria-current", "true");
    await demo.locator(".tool-undo").click();
    await expect.poll(() => stateOf(demo)).toEqual(before);
    await expect(link).not.toHaveAttribute("aria-current", "true");
  });

  test("jump where motion is not wanted", async ({ page }) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await page.goto("en/bezier/");
    await figure(page, "fig-curve");
    const events = await page
      .locator('a.state-link[href^="#fig-curve?"]')
      .first()
      .evaluate(async (element) => {
        const seen: boolean[] = [];
        document
          .querySelector("#fig-curve curve-demo")!
          .addEventListener("statechange", (event) => seen.push((event as CustomEvent).detail.committed));
        (element as HTMLElement).click();
        await new Promise((resolve) => setTimeout(resolve, 400));
        return seen;
      });
    expect(events).toEqual([true]);
  });

  test("prove the script's claims: partition of unity, symmetry, end tangents, convex hull", async ({
    page,
  }) => {
    await page.goto("de/bezier/");
    const links = await page
      .locator("a.state-link")
      .evaluateAll((all) => all.map((one) => one.getAttribute("href")!));
    for (const claim of [
      /^#fig-basis\?t=0\.1/,
      /^#fig-basis\?.*mirror=1/,
      /^#fig-ends\?points=/,
      /^#fig-hull\?points=/,
    ])
      expect(links.filter((href) => claim.test(href)).length, String(claim)).toBeGreaterThan(0);
  });
});

test.describe("predictions by keyboard", () => {
  test("a choice", async ({ page }) => {
    await page.goto("en/bezier/");
    await figure(page, "fig-hull");
    const block = page.locator("#predict-hull");
    const commit = block.locator(".commit");
    await expect(commit).toBeDisabled();
    await block.getByRole("radio").first().focus();
    await page.keyboard.press("Space");
    await expect(commit).toBeEnabled();
    await commit.focus();
    await page.keyboard.press("Enter");
    await expect(block.locator("details")).toHaveAttribute("open", "");
    await expect(block.locator(".result")).toHaveText("Not quite.");
    await expect(block.locator(".result")).toBeFocused();
    await expect(block.locator(".option.right .verdict")).toBeVisible();
    await expect(block.getByRole("radio").first()).toBeDisabled();
    await expect(page.locator("#fig-hull curve-demo")).toBeInViewport();
  });

  test("a number, with the decimal sign of either language", async ({ page }) => {
    await page.goto("de/bezier/");
    const demo = await figure(page, "fig-curve");
    const block = page.locator("#predict-lower");
    await block.getByRole("textbox").focus();
    await page.keyboard.type("0,55");
    await page.keyboard.press("Enter");
    await expect(block.locator(".result")).toHaveText("Stimmt. Ihre Zahl: 0,55. Richtig ist 0,6.");
    await expect.poll(async () => ((await stateOf(demo)).points as number[][])[2]![1]).toBe(1.1);
  });

  test("a mark placed in the picture", async ({ page }) => {
    await page.goto("en/bezier/");
    const demo = await figure(page, "fig-weights");
    const block = page.locator("#predict-half");
    await expect(block.locator(".commit")).toBeDisabled();
    await demo.locator('[data-handle="guess.0"]').focus();
    for (let i = 0; i < 16; i++) await page.keyboard.press("ArrowRight");
    for (let i = 0; i < 13; i++) await page.keyboard.press("ArrowDown");
    await expect(block.locator(".commit")).toBeEnabled();
    await block.locator(".commit").focus();
    await page.keyboard.press("Enter");
    await expect(block.locator(".result")).toHaveText(/^Right\. Your guess is 0\.\d+ units away/, {
      timeout: 15_000,
    });
    expect((await stateOf(demo)).t).toBe(0.5);
  });
});

test.describe("without JavaScript", () => {
  test.use({ javaScriptEnabled: false });
  test("predictions are read as question and answer; symbols have their list, buttons do not stand about", async ({
    page,
  }) => {
    await page.goto("de/bezier/");
    const block = page.locator("#predict-lower");
    await expect(block).toContainText("Um wie viel sinkt der Punkt");
    await expect(block.locator(".commit")).toBeHidden();
    await block.locator("summary").click();
    await expect(block.locator("details")).toContainText("Er sinkt um");
    await expect(page.locator(".symbols-button").first()).toBeHidden();
    await expect(page.locator("#symbols dd").first()).toContainText("Kontrollpunkt");
    await expect(page.locator("#eq-live .live").first()).toHaveText("(0,00; 0,00)");
  });
});

test("on paper a prediction is a question, with room", async ({ page }) => {
  await page.goto("de/bezier/");
  await page.emulateMedia({ media: "print" });
  const block = page.locator("#predict-half");
  await expect(block.locator(".question")).toBeVisible();
  for (const part of [".commit", ".answer"]) await expect(block.locator(part)).toBeHidden();
  const room = await block.evaluate((element) =>
    Number.parseFloat(getComputedStyle(element, "::after").height),
  );
  expect(room).toBeGreaterThan(40);
});

test("a drag with a live 4 × 4 matrix and four live formulas stays within its budget", async ({
  page,
  baseURL,
}) => {
  test.setTimeout(60_000);
  // The numbers of a matrix that follows the points: sixteen entries, four formulas more, all on the screen.
  const points = 'points="0,0;1,2;3,2;4,0"';
  const entry = (i: number, k: number) =>
    `\\live{${k < 2 ? `points.${i}.${k}` : k === 2 ? `weights.${i}` : "p.0"}}{-0.000}`;
  const matrix = [0, 1, 2, 3].map((i) => [0, 1, 2, 3].map((k) => entry(i, k)).join(" & ")).join(" \\\\ ");
  const formulas = [0, 1, 2, 3].map(
    (i) =>
      `$$\n\\live{weights.${i}}{0.000} \\cdot \\live{points.${i}}{-0.00} + \\live{p}{-0.00} = \\live{t}{0.00}\n$$`,
  );
  const text = `::: demo bezier-curve {#fig ${points} t=0.4}\nC.\n:::\n\n$$\n\\begin{pmatrix} ${matrix} \\end{pmatrix}\n$$\n\n${formulas.join("\n\n")}\n`;
  const front = "---\ntitle: T\nlead: L\nminutes: 1\ngoals:\n- g\n---\n";
  const { lesson, problems } = compileLesson(
    { id: "one", lang: "en", file: "one.md", source: front + text },
    { demos: new Map([["bezier-curve", basisDemo]]), still, readSource: () => null, identities: new Map() },
  );
  expect(problems).toEqual([]);
  // The page of the lesson, with this text instead of its own.
  await page.route("**/en/bezier/", async (route) => {
    const response = await route.fetch();
    const body = (await response.text()).replace(
      /(<main[^>]*>).*<\/main>/s,
      (_, main: string) => `${main}${lesson!.body}</main>`,
    );
    await route.fulfill({ response, body });
  });
  await page.setViewportSize({ width: 1000, height: 1700 });
  await page.goto(`${baseURL}en/bezier/`);
  const demo = await figure(page, "fig");
  expect(await page.locator(".live").count()).toBe(32);
  await expect(page.locator(".live").last()).toBeInViewport();

  const client = await page.context().newCDPSession(page);
  // Time that the main thread really ran: other programs of the machine do not count.
  await client.send("Performance.enable", { timeDomain: "threadTicks" });
  const work = async () => {
    const { metrics } = await client.send("Performance.getMetrics");
    return 1000 * metrics.find(({ name }) => name === "TaskDuration")!.value;
  };
  const { x, y } = await middleOf(demo.locator('[data-handle="points.1"]'));
  /** Milliseconds of the main thread for each move of the mouse, with or without a button held. */
  const moves = async (drag: boolean) => {
    const spent: number[] = [];
    await page.mouse.move(x, y);
    if (drag) await page.mouse.down();
    for (let i = 0; i < 60; i++) {
      const before = await work();
      await page.mouse.move(x + 30 * Math.sin(i / 5), y + 20 * Math.cos(i / 7));
      await page.evaluate(
        () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
      );
      spent.push((await work()) - before);
    }
    if (drag) {
      await page.mouse.up();
      await page.keyboard.press("Control+z");
    }
    return spent.sort((a, b) => a - b);
  };
  const p95 = (sorted: readonly number[]) => sorted[Math.floor(0.95 * sorted.length)]!;
  const runs: number[] = [];
  await moves(true);
  for (let run = 0; run < 3; run++) {
    const idle = await moves(false);
    const dragged = await moves(true);
    runs.push(p95(dragged) - p95(idle));
  }
  const median = runs.sort((a, b) => a - b)[1]!;
  test
    .info()
    .annotations.push({ type: "ms a move, p95", description: runs.map((ms) => ms.toFixed(2)).join(", ") });
  expect(median).toBeLessThanOrEqual(4);
});
