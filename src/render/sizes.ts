/** Lengths of the drawing in pixels at scale 1. */
export const SIZE = {
  label: 17,
  script: 12,
  axisNumber: 12,
  axisName: 15,
  words: 14,
  /** Radii. */
  ring: 9,
  shape: 5,
  point: 5.5,
  smallPoint: 3.5,
  arrowLength: 11,
  arrowWidth: 8,
} as const;

/** All sizes of lettering besides that of labels: numbers, words, names of axes, and what is set small there. */
export const TEXT_SIZES = [SIZE.script, SIZE.words, SIZE.axisName, 11, 10];

/** The families of lettering: symbols, digits and brackets, words. */
export const FONTS = {
  math: 'KaTeX_Math, "Latin Modern Math", "STIX Two Text", Cambria, Georgia, serif',
  main: 'KaTeX_Main, "Latin Modern Math", "STIX Two Text", Cambria, Georgia, serif',
  text: '"Source Sans 3", "Source Sans Pro", "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif',
} as const;

export type Font = keyof typeof FONTS;
