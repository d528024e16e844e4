import { describe, expect, test } from "vitest";
import { displayList } from "../../src/render/display-list.ts";
import { paintOf } from "../../src/render/paint.ts";
import { PARTS, type Part, ROLES } from "../../src/render/roles.ts";
import { setLabel } from "../../src/render/set-label.ts";
import { SIZE } from "../../src/render/sizes.ts";
import { type SvgNode, svgTree } from "../../src/render/svg-tree.ts";
import { figureCss, palettes, themeCss } from "../../src/render/theme.ts";
import type { Role } from "../../src/scene/marks.ts";
import { scene, views } from "./all-kinds.ts";

// The compiler sees to it that the table has every role.
const roles = Object.keys(ROLES) as Role[];
const parts = Object.keys(PARTS) as Part[];

describe("the table of roles", () => {
  test.each(roles)("%s: every part paints something, in a token of every theme", (role) => {
    for (const part of parts) {
      for (const index of [undefined, 0, 9]) {
        const paint = paintOf(role, part, index);
        expect(paint.fill ?? paint.stroke, `${part} ${index}`).toBeDefined();
        for (const palette of Object.values(palettes)) {
          if (paint.fill) expect(palette[paint.fill]).toBeTruthy();
          if (paint.stroke) expect(palette[paint.stroke]).toBeTruthy();
        }
        if (paint.stroke) expect(paint.width).toBeGreaterThan(0);
      }
    }
  });

  test("the design's widths: curve 2.5, control polygon and derived lines 1.25, ghosts dashed", () => {
    expect(paintOf("curve", "line").width).toBe(2.5);
    expect(paintOf("control-polygon", "line").width).toBe(1.25);
    expect(paintOf("derived", "line").width).toBe(1.25);
    expect(paintOf("ghost", "line").dash).toBeDefined();
    expect(paintOf("curve", "line").dash).toBeUndefined();
  });

  test("what can be moved has the accent, and the index colour where it has an index", () => {
    expect(paintOf("handle", "ring").stroke).toBe("lath");
    expect(paintOf("handle", "ring", 12).stroke).toBe("index-2");
  });

  test("lettering on a weight's region stays paper, that of a derived point takes its index", () => {
    expect(paintOf("weight", "plain", 3).fill).toBe("paper");
    expect(paintOf("weight", "area", 3)).toMatchObject({ fill: "index-3", fillOpacity: 1 });
    expect(paintOf("derived", "text", 3).fill).toBe("index-3");
    expect(paintOf("hull", "text").fill).toBe("soft");
  });
});

describe("themeCss", () => {
  test("gives every token in light, dark by choice and by system, print and forced colours", () => {
    const css = themeCss();
    const count = Object.keys(palettes.light).length;
    for (const token of Object.keys(palettes.light)) {
      expect(css.split(`--${token}:`).length - 1, token).toBe(5);
    }
    expect(css.match(/--[a-z0-9-]+:/g)).toHaveLength(5 * count);
    expect(css).toContain(`:root{color-scheme:light;--paper:${palettes.light.paper}`);
    expect(css).toContain(`:root[data-theme="dark"]{color-scheme:dark;--paper:${palettes.dark.paper}`);
    expect(css).toContain('@media (prefers-color-scheme:dark){:root:not([data-theme="light"])');
    expect(css).toContain("@media print{");
    expect(css).toContain("@media (forced-colors:active){");
  });

  test("speaks of the host of a shadow root in its own way", () => {
    expect(themeCss(":host")).toContain(':host([data-theme="dark"])');
    expect(themeCss(":host")).not.toContain(":host[");
  });
});

test("every size of lettering that can occur has a class", () => {
  const css = figureCss("svg");
  const label = { base: "B", sub: "i", args: [1] };
  for (const size of [undefined, SIZE.axisName, SIZE.words]) {
    for (const run of setLabel(label, "de", size).runs) {
      if (run.size !== SIZE.label) expect(css).toContain(`svg .s${run.size}{font-size:${run.size}px}`);
    }
  }
  for (const run of setLabel({ ...label, style: "text" }, "de").runs) expect(css).toContain(`.s${run.size}{`);
});

test("figureCss has a rule for every class of a picture in a page", () => {
  const css = figureCss("figure > svg");
  const classes = new Set<string>();
  const collect = ({ attributes, children }: SvgNode) => {
    for (const name of String(attributes.class ?? "").split(" ")) if (name) classes.add(name);
    for (const child of children) if (typeof child !== "string") collect(child);
  };
  const lit = new Set(["path", "point", "arrow"]);
  const drawing = displayList(views, scene, { width: 736, height: 736, lang: "de", lit });
  collect(svgTree(drawing, { title: "" }));
  classes.delete("facets");
  expect(classes.size).toBeGreaterThan(25);
  for (const name of classes) expect(css).toMatch(new RegExp(`figure > svg \\.${name}\\{`));
  expect(css.length).toBeLessThan(9000);
});
