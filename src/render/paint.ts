import type { Role } from "../scene/marks.ts";
import { indexToken, type Token } from "./palette.ts";
import { PARTS, type Part, type PartStyle, ROLES, type RoleStyle } from "./roles.ts";

/** How a primitive is painted, in tokens of the palette. */
export interface Paint {
  readonly fill?: Token;
  readonly fillOpacity: number;
  readonly stroke?: Token;
  readonly strokeOpacity: number;
  readonly width: number;
  readonly dash?: readonly number[];
}

const found = new Map<string, Paint>();

/** The paint of a part of a mark with the given role and index. */
export function paintOf(role: Role, part: Part, index?: number): Paint {
  const id = `${role} ${part} ${index}`;
  let paint = found.get(id);
  if (!paint) {
    paint = resolve(ROLES[role], PARTS[part], index);
    found.set(id, paint);
  }
  return paint;
}

function resolve(role: RoleStyle, part: PartStyle, index: number | undefined): Paint {
  const token = (which: "own" | "text" | "paper"): Token => {
    if (which === "paper") return "paper";
    // Lettering on the filled regions of weights stays paper, whatever their index.
    if (which === "text" && (index === undefined || role.text === "paper")) return role.text ?? role.token;
    return index === undefined ? role.token : indexToken(index);
  };
  const dash = part.dash === "role" ? role.dash : undefined;
  return {
    ...(part.fill ? { fill: token(part.fill) } : {}),
    fillOpacity: part.fillOpacity === "role" ? role.fill : (part.fillOpacity ?? 1),
    ...(part.stroke ? { stroke: token(part.stroke) } : {}),
    strokeOpacity: part.opacity ?? 1,
    width: part.width === "role" ? role.width : (part.width ?? 0),
    ...(dash ? { dash } : {}),
  };
}
