// Written by "npm run data:glyph" from the font Source Serif 4 (@fontsource-variable/source-serif-4), regular weight.
// The font is under the SIL Open Font License 1.1: source-serif-4.LICENSE.txt.
import type { GlyphOutline } from "./glyph-outline.ts";

export const glyphE: GlyphOutline = {
  letter: "e",
  unitsPerEm: 1000,
  points: [
    [286, -12], // 0 on the curve
    [211, -12], // 1
    [104, 49], // 2
    [47, 162], // 3
    [47, 239], // 4 on the curve
    [47, 317], // 5
    [107, 436], // 6
    [213, 504], // 7
    [281, 504], // 8 on the curve
    [342, 504], // 9
    [432, 457], // 10
    [483, 369], // 11
    [483, 308], // 12 on the curve
    [483, 289], // 13
    [478, 252], // 14
    [475, 240], // 15 on the curve
    [100, 240], // 16 on the curve
    [100, 287], // 17 on the curve
    [362, 287], // 18 on the curve
    [383, 294], // 19
    [395, 320], // 20
    [395, 337], // 21 on the curve
    [395, 376], // 22
    [368, 427], // 23
    [317, 452], // 24
    [281, 452], // 25 on the curve
    [243, 452], // 26
    [179, 410], // 27
    [141, 321], // 28
    [141, 249], // 29 on the curve
    [141, 188], // 30
    [182, 101], // 31
    [257, 55], // 32
    [307, 55], // 33 on the curve
    [360, 55], // 34
    [431, 94], // 35
    [459, 126], // 36 on the curve
    [490, 101], // 37 on the curve
    [468, 68], // 38
    [414, 16], // 39
    [340, -12], // 40
  ],
  onCurve: [
    true, false, false, false, true, false, false, false, true, false, false, false, true, false, false, true, true, true, true, false, false, true, false, false, false, true, false, false, false, true, false, false, false, true, false, false, true, true, false, false, false,
  ],
  ends: [40],
};
