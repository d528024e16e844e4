import { afterEach, describe, expect, test, vi } from "vitest";
import { recall, remember } from "../../src/site/storage.ts";

afterEach(() => vi.unstubAllGlobals());

function working(): Map<string, string> {
  const kept = new Map<string, string>();
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => kept.set(key, value),
    removeItem: (key: string) => kept.delete(key),
  });
  return kept;
}

describe("storage", () => {
  test("keeps values under the site's own names", () => {
    const kept = working();
    remember("theme", "dark");
    expect([...kept]).toEqual([["straklatte.theme", "dark"]]);
    expect(recall("theme")).toBe("dark");
    remember("theme", null);
    expect(kept.size).toBe(0);
    expect(recall("theme")).toBeNull();
  });

  test("where every access throws, a memory takes its place", () => {
    vi.stubGlobal("localStorage", undefined);
    remember("language", "en");
    expect(recall("language")).toBe("en");
    remember("language", null);
    expect(recall("language")).toBeNull();
  });

  test("what another page has stored counts", () => {
    const kept = working();
    remember("theme", "dark");
    kept.set("straklatte.theme", "light");
    expect(recall("theme")).toBe("light");
  });
});
