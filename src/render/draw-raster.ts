import type { RasterMark } from "../scene/marks.ts";
import { levelOf } from "./colour-map.ts";
import { base, clipOf, isFinitePoint, type Sheet } from "./sheet.ts";

/** The cells of a raster as levels of its colour map, turned over so that the first row is at the top. */
export function drawRaster(mark: RasterMark, sheet: Sheet): void {
  const { columns, rows, values, range } = mark;
  const [left, bottom] = sheet.transform.toPixel([mark.x[0], mark.y[0]]);
  const [right, top] = sheet.transform.toPixel([mark.x[1], mark.y[1]]);
  if (!isFinitePoint([left, bottom]) || !isFinitePoint([right, top]) || columns < 1 || rows < 1) return;
  const levels = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      levels[(rows - 1 - row) * columns + column] = levelOf(
        values[row * columns + column] ?? Number.NaN,
        range,
      );
    }
  }
  sheet.primitives.push({
    kind: "raster",
    ...base(mark, "solid"),
    key: mark.key,
    box: { left, top, width: right - left, height: bottom - top },
    columns,
    rows,
    levels,
    colours: mark.colours,
    ...clipOf(
      [
        ["M", [left, top]],
        ["L", [right, bottom]],
      ],
      sheet.transform.box,
    ),
  });
}
