import { bezier } from "./bezier.ts";
import { hermite } from "./hermite.ts";
import type { Identity } from "./identity.ts";
import { surfaces } from "./surfaces.ts";

/** All checks, by the ids that the lessons name; a lesson's checks are one file. */
export const identities: Readonly<Record<string, Identity>> = { ...bezier, ...hermite, ...surfaces };
