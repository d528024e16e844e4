import { LEVELS, mapColour, NO_VALUE } from "./colour-map.ts";

/**
 * A picture of the cells as a data URL: an indexed PNG without compression (blocks of plain bytes), small
 * enough for the grids of this course, and written without browser or Node.
 */
export function pngUrl(
  columns: number,
  rows: number,
  levels: Uint8Array,
  colours: "sequential" | "diverging",
): string {
  const palette = new Uint8Array(256 * 3);
  for (let level = 0; level < LEVELS; level++) palette.set(mapColour(colours, level), level * 3);
  const transparent = new Uint8Array(256).fill(255);
  transparent[NO_VALUE] = 0;
  const raw = new Uint8Array(rows * (columns + 1));
  for (let row = 0; row < rows; row++) {
    raw.set(levels.subarray(row * columns, (row + 1) * columns), row * (columns + 1) + 1);
  }
  const bytes = [
    Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10),
    chunk("IHDR", [...bigEndian(columns), ...bigEndian(rows), 8, 3, 0, 0, 0]),
    chunk("PLTE", palette),
    chunk("tRNS", transparent),
    chunk("IDAT", stored(raw)),
    chunk("IEND", []),
  ];
  return `data:image/png;base64,${base64(joined(bytes))}`;
}

function chunk(name: string, data: ArrayLike<number>): Uint8Array {
  const body = new Uint8Array(4 + data.length);
  body.set([...name].map((c) => c.charCodeAt(0)));
  body.set(data, 4);
  return joined([bigEndian(data.length), body, bigEndian(crc32(body))]);
}

/** A zlib stream of stored blocks (RFC 1950, RFC 1951 section 3.2.4). */
function stored(data: Uint8Array): Uint8Array {
  const parts: Uint8Array[] = [Uint8Array.of(0x78, 0x01)];
  for (let from = 0; from === 0 || from < data.length; from += 0xffff) {
    const block = data.subarray(from, from + 0xffff);
    const last = from + 0xffff >= data.length ? 1 : 0;
    const [low, high] = [block.length & 255, block.length >> 8];
    parts.push(Uint8Array.of(last, low, high, low ^ 255, high ^ 255), block);
  }
  return joined([...parts, bigEndian(adler32(data))]);
}

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; k++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

function crc32(data: Uint8Array): number {
  let c = 0xffffffff;
  for (const byte of data) c = crcTable[(c ^ byte) & 255]! ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

function adler32(data: Uint8Array): number {
  let [a, b] = [1, 0];
  for (const byte of data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return ((b << 16) | a) >>> 0;
}

function bigEndian(value: number): Uint8Array {
  return Uint8Array.of(value >>> 24, (value >>> 16) & 255, (value >>> 8) & 255, value & 255);
}

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

function base64(bytes: Uint8Array): string {
  let text = "";
  for (let i = 0; i < bytes.length; i += 3) {
    const three = (bytes[i]! << 16) | ((bytes[i + 1] ?? 0) << 8) | (bytes[i + 2] ?? 0);
    text += DIGITS[three >> 18]! + DIGITS[(three >> 12) & 63]!;
    text += i + 1 < bytes.length ? DIGITS[(three >> 6) & 63]! : "=";
    text += i + 2 < bytes.length ? DIGITS[three & 63]! : "=";
  }
  return text;
}
