import { runInNewContext } from "node:vm";
import { describe, expect, test } from "vitest";
import { BOOT } from "../../src/build/templates/boot.ts";

/** Runs the inline line of a page and gives the theme it sets. */
function boot(page: { search?: string; stored?: string | null; framed?: boolean; refused?: boolean }) {
  const touched: string[] = [];
  const self = {};
  const root = {
    dataset: {} as Record<string, string>,
    classList: { add: (name: string) => touched.push(name) },
  };
  runInNewContext(BOOT, {
    self,
    top: page.framed ? {} : self,
    URLSearchParams,
    location: { search: page.search ?? "" },
    document: { documentElement: root },
    localStorage: {
      getItem: (key: string) => {
        touched.push("storage");
        if (page.refused) throw new Error("denied");
        return key === "straklatte.theme" ? (page.stored ?? null) : null;
      },
    },
  });
  return { theme: root.dataset.theme, touched };
}

describe("the boot line", () => {
  test("takes the stored theme, else the system's", () => {
    expect(boot({ stored: "dark" }).theme).toBe("dark");
    expect(boot({}).theme).toBeUndefined();
    expect(boot({ stored: "pink" }).theme).toBeUndefined();
  });

  test("the query comes before what is stored", () => {
    expect(boot({ search: "?t=0.5&theme=light", stored: "dark" }).theme).toBe("light");
  });

  test("in a frame it never touches the storage", () => {
    const { theme, touched } = boot({ framed: true, stored: "dark" });
    expect(theme).toBeUndefined();
    expect(touched).toEqual(["js"]);
  });

  test("says that scripts run, even where storage is refused", () => {
    expect(boot({ refused: true }).touched).toEqual(["storage", "js"]);
  });
});
