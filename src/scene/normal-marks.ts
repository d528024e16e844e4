import { arrow, label, polyline } from "./draw.ts";
import { symbol, wording } from "./label.ts";
import type { Mark } from "./marks.ts";

/**
 * The unit normal n at a point of a surface, drawn `length` long. Where there is none, the picture says so; if the
 * normals of the neighbourhood have a limit there, it is dashed.
 */
export function normalMarks(
  at: readonly number[],
  normal: readonly number[] | null,
  length: number,
  limit: readonly number[] | null = null,
): Mark[] {
  const tip = (n: readonly number[]) => at.map((x, k) => x + n[k]! * length);
  if (normal) {
    const end = tip(normal);
    return [
      arrow("normal", "tangent", at, end, { name: "normal" }),
      label("normal-label", "tangent", end, symbol("n"), { toward: normal }),
    ];
  }
  const none = wording({ de: "hier gibt es keine Normale", en: "no normal here" });
  return [
    ...(limit ? [polyline("normal-limit", "ghost", [at, tip(limit)], { name: "limit" })] : []),
    label("no-normal", "bad", at, none, { name: "normal" }),
  ];
}
