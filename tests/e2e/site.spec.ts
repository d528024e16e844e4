import AxeBuilder from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { alive, hostPage, stateOf } from "./support/figure.ts";

const LESSON = "/de/bezier/";
const PAGES = ["/", "/de/", "/en/", LESSON, "/en/bezier/", "/404.html"];
const theme = (page: Page) => page.evaluate(() => document.documentElement.dataset.theme ?? "auto");
const paper = (page: Page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

/** The first state link of the lesson, and the figure it speaks of. */
async function firstLink(page: Page) {
  const link = page.locator("a.state-link").first();
  const [, id, query] = /^#([^?]+)\?(.*)$/.exec((await link.getAttribute("href"))!)!;
  return { link, id: id!, query: query!, selector: `#${id} > curve-demo` };
}

test.describe("theme", () => {
  test("the switch goes light, dark, system; names where it stands; is kept on the next page", async ({
    page,
  }) => {
    await page.goto("/de/");
    const button = page.getByRole("button", { name: "Farben" });
    const papers = [await paper(page)];
    for (const [setting, name] of [
      ["light", "Farben: hell"],
      ["dark", "Farben: dunkel"],
    ] as const) {
      await button.click();
      expect(await theme(page)).toBe(setting);
      await expect(button).toHaveAccessibleName(name);
      papers.push(await paper(page));
    }
    expect(papers[2]).not.toBe(papers[1]);
    await page.goto(LESSON);
    expect(await theme(page)).toBe("dark");
    expect(await paper(page)).toBe(papers[2]);
    await button.click();
    expect(await theme(page)).toBe("auto");
    await expect(button).toHaveAccessibleName("Farben: wie das System");
  });

  test("without a setting the page follows the system", async ({ page }) => {
    await page.emulateMedia({ colorScheme: "dark" });
    await page.goto("/de/");
    const dark = await paper(page);
    await page.emulateMedia({ colorScheme: "light" });
    expect(await paper(page)).not.toBe(dark);
  });
});

test.describe("language", () => {
  test("the link leads to the same place in the other language, state of the figure and all", async ({
    page,
  }) => {
    await page.goto(LESSON);
    const { id, query } = await firstLink(page);
    await page.goto(`${LESSON}#${id}?${query}`);
    await page.getByRole("link", { name: "English" }).click();
    await expect(page).toHaveURL(new RegExp(`/en/bezier/#${id}\\?`));
    await expect(page.locator("html")).toHaveAttribute("lang", "en");
  });

  test("the root asks once and then goes on by itself", async ({ page }) => {
    await page.goto("/");
    await page.getByRole("link", { name: /English/ }).click();
    await expect(page).toHaveURL(/\/en\/$/);
    await page.goto("/");
    await expect(page).toHaveURL(/\/en\/$/);
  });
});

test.describe("state links", () => {
  test("set their figure, show that it is in their state, and leave no trace in the history", async ({
    page,
  }) => {
    await page.goto(LESSON);
    const { link, id, selector } = await firstLink(page);
    const entries = await page.evaluate(() => history.length);
    // By key: a link that is broken across two lines has no middle to click on.
    await link.press("Enter");
    await expect(link).toHaveAttribute("aria-current", "true");
    await expect(page).toHaveURL(new RegExp(`#${id}\\?`));
    expect(await page.evaluate(() => history.length)).toBe(entries);

    const figure = await alive(page, selector);
    const there = await stateOf(figure);
    const copy = await page.context().newPage();
    await copy.goto(page.url());
    await expect.poll(async () => stateOf(await alive(copy, selector))).toEqual(there);
    await copy.close();
    await figure.locator(".tool-undo").click();
    await expect(link).not.toHaveAttribute("aria-current");
    await expect(page).not.toHaveURL(/\?/);
  });

  test("bring their figure into view", async ({ page }) => {
    await page.setViewportSize({ width: 800, height: 600 });
    await page.goto(LESSON);
    const { link, selector } = await firstLink(page);
    await link.focus();
    await link.evaluate((element) => element.scrollIntoView({ block: "end" }));
    await page.keyboard.press("Enter");
    const figure = page.locator(selector);
    await expect
      .poll(() =>
        figure.evaluate((element) => {
          const { top, bottom, height } = element.getBoundingClientRect();
          return (Math.min(bottom, innerHeight) - Math.max(top, 0)) / Math.min(height, innerHeight);
        }),
      )
      .toBeGreaterThan(0.75);
  });

  test("an address with a state opens there, and so does a later change of the hash", async ({ page }) => {
    await page.goto(LESSON);
    const { id, query, selector } = await firstLink(page);
    await page.goto("about:blank");
    await page.goto(`${LESSON}#${id}?${query}`);
    const figure = page.locator(`${selector}[data-ready]`);
    await figure.waitFor();
    await expect(figure).toBeInViewport({ ratio: 0.5 });
    const there = await stateOf(figure);
    await figure.locator(".tool-reset").click();
    await expect.poll(() => stateOf(figure)).not.toEqual(there);
    await page.evaluate((hash) => {
      location.hash = hash;
    }, `${id}?${query}`);
    await expect.poll(() => stateOf(figure)).toEqual(there);
  });
});

test.describe("contents", () => {
  test("the section being read is marked, the last one at the end", async ({ page }) => {
    await page.setViewportSize({ width: 1400, height: 900 });
    await page.goto(LESSON);
    const marked = page.locator('.contents .sections [aria-current="true"]');
    await expect(marked).toHaveCount(0);
    const sections = page.locator(".contents .sections a");
    for (const place of [2, 0]) {
      const link = sections.nth(place);
      await link.click();
      await expect(marked).toHaveCount(1);
      await expect(link).toHaveAttribute("aria-current", "true");
    }
    await page.keyboard.press("End");
    await expect(sections.last()).toHaveAttribute("aria-current", "true");
  });

  test.describe("on a phone", () => {
    test.use({ viewport: { width: 390, height: 800 } });

    test("the button opens the sheet, Escape and a chosen section close it", async ({ page }) => {
      await page.goto(LESSON);
      const sheet = page.locator("#contents");
      const button = page.getByRole("button", { name: "Inhalt", exact: true });
      await expect(sheet).toBeHidden();
      await button.click();
      await expect(sheet).toBeVisible();
      await page.keyboard.press("Escape");
      await expect(sheet).toBeHidden();
      await expect(button).toBeFocused();
      await button.click();
      await page.locator(".contents .sections a").nth(1).click();
      await expect(sheet).toBeHidden();
      await expect(page.locator("main h2").nth(1)).toBeInViewport();
    });

    test("without a script it opens as well", async ({ browser, baseURL }) => {
      const context = await browser.newContext({
        ...(baseURL === undefined ? {} : { baseURL }),
        javaScriptEnabled: false,
        viewport: { width: 390, height: 800 },
      });
      const page = await context.newPage();
      await page.goto(LESSON);
      await page.locator(".contents-button").click();
      await expect(page.locator("#contents")).toBeVisible();
      await context.close();
    });
  });
});

test.describe("on narrow screens and with large type nothing is lost", () => {
  for (const [width, size] of [
    [320, "100%"],
    [640, "200%"],
  ] as const) {
    test(`${width} px, ${size}`, async ({ page }) => {
      await page.setViewportSize({ width, height: 800 });
      for (const path of PAGES) {
        await page.goto(path);
        await page.evaluate((fontSize) => {
          document.documentElement.style.fontSize = fontSize;
        }, size);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        expect(wide, path).toBeLessThanOrEqual(width);
      }
    });
  }

  test("a formula that is too wide scrolls by keys; one that fits is no stop for Tab", async ({ page }) => {
    await page.setViewportSize({ width: 340, height: 800 });
    await page.goto(LESSON);
    const boxes = page.locator(".formula");
    const checked: boolean[] = [];
    for (let i = 0; i < Math.min(12, await boxes.count()); i += 1) {
      const box = boxes.nth(i);
      await box.scrollIntoViewIfNeeded();
      await page.waitForTimeout(60);
      const { wide, stop, name } = await box.evaluate((element) => ({
        wide: element.scrollWidth > element.clientWidth + 1,
        stop: element.getAttribute("tabindex") === "0",
        name: element.getAttribute("aria-label"),
      }));
      expect(stop).toBe(wide);
      if (wide) expect(name).toBeTruthy();
      checked.push(wide);
    }
    expect(new Set(checked)).toEqual(new Set([true, false]));
  });

  test("what is touched in header and contents is 44 pixels or more", async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 800 });
    await page.goto(LESSON);
    await page.locator(".contents-button").click();
    const small = await page.evaluate(() =>
      [...document.querySelectorAll<HTMLElement>(".top a, .top button, .contents a, .contents button")]
        .filter((target) => target.checkVisibility())
        .map((target) => ({ name: target.outerHTML.slice(0, 80), box: target.getBoundingClientRect() }))
        .filter(({ box }) => box.height < 43.5 || box.width < 43.5)
        .map(({ name }) => name),
    );
    expect(small).toEqual([]);
  });
});

test("nothing moves by itself while the lesson is read and its figures come alive", async ({ page }) => {
  await page.addInitScript(() => {
    const shifts: number[] = [];
    Object.assign(window, { shifts });
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        const shift = entry as PerformanceEntry & { value: number; hadRecentInput: boolean };
        if (!shift.hadRecentInput) shifts.push(shift.value);
      }
    }).observe({ type: "layout-shift", buffered: true });
  });
  for (const width of [1400, 390]) {
    await page.setViewportSize({ width, height: 900 });
    await page.goto(LESSON);
    // What fonts do on their way here is a matter of the network, measured elsewhere.
    await page.evaluate(async () => {
      await document.fonts.ready;
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 100)));
      (window as unknown as { shifts: number[] }).shifts.length = 0;
    });
    await page.mouse.move(width / 2, 450);
    const end = await page.evaluate(() => document.documentElement.scrollHeight);
    for (let y = 0; y < end; y += 700) {
      await page.mouse.wheel(0, 700);
      await page.waitForTimeout(60);
    }
    const sum = await page.evaluate(() =>
      (window as unknown as { shifts: number[] }).shifts.reduce((all, one) => all + one, 0),
    );
    expect(sum, `${width} px`).toBeLessThanOrEqual(0.003);
  }
});

test("a living figure takes exactly the place its still picture had", async ({ page }) => {
  for (const width of [1400, 390]) {
    await page.setViewportSize({ width, height: 900 });
    await page.route("**/*.js", (route) => route.abort());
    await page.goto(LESSON);
    const heights = () =>
      page.evaluate(() =>
        [...document.querySelectorAll("curve-demo")]
          .slice(0, 3)
          .map((one) => one.getBoundingClientRect().height),
      );
    const before = await heights();
    await page.unroute("**/*.js");
    await page.goto(LESSON);
    for (let i = 0; i < before.length; i += 1) {
      const figure = page.locator("curve-demo").nth(i);
      await figure.scrollIntoViewIfNeeded();
      await expect(figure).toHaveAttribute("data-ready");
    }
    const after = await heights();
    for (const [i, height] of after.entries()) {
      expect(Math.abs(height - before[i]!), `figure ${i + 1} at ${width} px`).toBeLessThan(1);
    }
  }
});

test("in a sandboxed frame, where storage throws, everything still works", async ({ page }) => {
  const errors: string[] = [];
  page.on("pageerror", (error) => errors.push(error.message));
  // Modules of an opaque origin need this header on every file.
  await page.route("**/*.{js,css,woff2}", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), "access-control-allow-origin": "*" } });
  });
  await hostPage(
    page,
    `<iframe src="${LESSON}" width="1000" height="700" sandbox="allow-scripts" title="lesson"></iframe>`,
  );
  const frame = page.frameLocator("iframe");
  await frame.locator("curve-demo").first().scrollIntoViewIfNeeded();
  await frame.locator("curve-demo[data-ready]").first().waitFor();
  const button = frame.getByRole("button", { name: "Farben" });
  await button.click();
  await expect(frame.locator("html")).toHaveAttribute("data-theme", "light");
  expect(errors).toEqual([]);
});

test.describe("print", () => {
  test("a handout: no chrome, every section and figure, the caption for paper", async ({ page }) => {
    await page.goto(LESSON);
    await page.emulateMedia({ media: "print" });
    for (const hidden of [".top", ".contents", ".foot"]) await expect(page.locator(hidden)).toBeHidden();
    await expect(page.locator("figcaption .on-screen:visible")).toHaveCount(0);
    expect(await page.locator("figcaption .on-paper:visible").count()).toBeGreaterThan(0);
    const late = await page.evaluate(
      () =>
        [...document.querySelectorAll("main section")].filter(
          (one) => getComputedStyle(one).contentVisibility !== "visible",
        ).length,
    );
    expect(late).toBe(0);
    const pictures = await page.evaluate(() =>
      [...document.querySelectorAll("curve-demo > svg")].map((one) => one.getBoundingClientRect().height),
    );
    expect(pictures.length).toBeGreaterThan(3);
    expect(Math.min(...pictures)).toBeGreaterThan(80);
  });
});

test.describe("accessibility", () => {
  for (const colorScheme of ["light", "dark"] as const) {
    for (const path of PAGES) {
      test(`${path}, ${colorScheme}`, async ({ page }) => {
        test.slow();
        await page.emulateMedia({ colorScheme });
        await page.goto(path);
        if (await page.locator("curve-demo").count()) await alive(page);
        // Formulas for the eye (MathML stands beside them) and still pictures are hidden from the ear; their many
        // thousand nodes would only take time.
        await page.evaluate(() => {
          for (const hidden of document.querySelectorAll(".katex-html, curve-demo > svg")) hidden.remove();
        });
        const { violations } = await new AxeBuilder({ page })
          .withTags(["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"])
          .analyze();
        expect(
          violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" | ")}`),
        ).toEqual([]);
      });
    }
  }

  test("the first Tab offers to skip to the content", async ({ page }) => {
    await page.goto(LESSON);
    await page.keyboard.press("Tab");
    const skip = page.getByRole("link", { name: "Zum Inhalt springen" });
    await expect(skip).toBeFocused();
    await expect(skip).toBeInViewport();
    await page.keyboard.press("Enter");
    await expect(page.locator("main")).toBeFocused();
  });
});
