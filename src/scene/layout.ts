import type { Box, View } from "./view.ts";

export type Views = Readonly<Record<string, View>>;

/** Below this width, in pixels at scale 1, the windows of a figure stand below each other. */
export const NARROW = 560;

/** Space around every window; for the numbers and names at its axes; beside the ends of an axis. */
const INSET = { plain: 6, numbersLeft: 34, numbersBottom: 24, nameTop: 24, nameRight: 14, end: 10 };

/** Which axes a window shows: those that are named, be it by the empty name, or both where none is. */
export function shownAxes({ axes }: View): { readonly x: boolean; readonly y: boolean } {
  if (!axes) return { x: false, y: false };
  return { x: !!axes.x || !axes.y, y: !!axes.y || !axes.x };
}

function insets(view: View): { left: number; right: number; top: number; bottom: number } {
  const { plain, numbersLeft, numbersBottom, nameTop, nameRight, end } = INSET;
  const { x, y } = shownAxes(view);
  if (!x && !y) return { left: plain, right: plain, top: plain, bottom: plain };
  return {
    left: y ? numbersLeft : end,
    right: view.axes?.x?.base ? nameRight : end,
    top: view.axes?.y?.base ? nameTop : end,
    bottom: x ? numbersBottom : end,
  };
}

/** Height of the whole drawing as a share of its width. */
export function aspect(views: Views, narrow: boolean): number {
  return rows(views, narrow).reduce((sum, row) => sum + row.height, 0);
}

interface Row {
  readonly height: number;
  readonly cells: readonly { readonly id: string; readonly from: number; readonly width: number }[];
}

function rows(views: Views, narrow: boolean): Row[] {
  const found: { height: number; cells: { id: string; from: number; width: number }[] }[] = [];
  for (const [id, view] of Object.entries(views)) {
    const row = found.at(-1);
    const height = narrow ? (view.narrowHeight ?? Math.min(1, view.height * 1.4)) : view.height;
    if (!narrow && view.beside !== undefined && row) {
      // The cells to the left make room in proportion.
      const rest = 1 - view.beside;
      for (const cell of row.cells) {
        cell.from *= rest;
        cell.width *= rest;
      }
      row.cells.push({ id, from: rest, width: view.beside });
      row.height = Math.max(row.height, height);
    } else {
      found.push({ height, cells: [{ id, from: 0, width: 1 }] });
    }
  }
  return found;
}

/** A row flatter than this share of the width is a bar: it keeps its height, whatever the others do. */
const BAR = 0.2;

/** The heights of the rows in a drawing of the given size: bars as they are, the others share the rest. */
function heights(all: readonly Row[], width: number, height: number): number[] {
  const natural = all.map((row) => row.height * width);
  const isBar = (i: number) => all[i]!.height < BAR;
  const bars = natural.reduce((sum, h, i) => (isBar(i) ? sum + h : sum), 0);
  const others = natural.reduce((sum, h) => sum + h, 0) - bars;
  // Where even the bars do not fit, or there is nothing else, all shrink or grow alike.
  if (others === 0 || bars > height / 2) return natural.map((h) => (h / (bars + others)) * height);
  return natural.map((h, i) => (isBar(i) ? h : (h / others) * (height - bars)));
}

/**
 * The box of each view's plane in a drawing of the given size (pixels at scale 1). A drawing that is taller
 * or flatter than the figure asks for is filled all the same, as on a slide.
 */
export function layoutViews(views: Views, width: number, height: number): Readonly<Record<string, Box>> {
  const narrow = width < NARROW;
  const all = rows(views, narrow);
  const tallness = heights(all, width, height);
  const boxes: Record<string, Box> = {};
  let top = 0;
  for (const [i, row] of all.entries()) {
    const tall = tallness[i]!;
    for (const cell of row.cells) {
      const view = views[cell.id]!;
      const inset = insets(view);
      boxes[cell.id] = {
        left: cell.from * width + inset.left,
        top: top + inset.top,
        width: Math.max(1, cell.width * width - inset.left - inset.right),
        height: Math.max(1, tall - inset.top - inset.bottom),
      };
    }
    top += tall;
  }
  return boxes;
}
