import { cross, dot, norm, type Point, scale } from "./point.ts";
import type { Surface } from "./surface.ts";
import { surfaceNormal } from "./surface-normal.ts";

/** The two fundamental forms of a surface at a point: lengths (E, F, G) and bending (L, M, N) along the parameters. */
export type FundamentalForms = {
  /** S_u · S_u, S_u · S_v, S_v · S_v. */
  readonly E: number;
  readonly F: number;
  readonly G: number;
  /** S_uu · n, S_uv · n, S_vv · n. */
  readonly L: number;
  readonly M: number;
  readonly N: number;
  readonly normal: Point;
};

/** The fundamental forms of a surface in space, or `null` where it has no normal (see `surfaceNormal`). */
export function fundamentalForms(surface: Surface, u: number, v: number): FundamentalForms | null {
  const normal = surfaceNormal(surface, u, v);
  if (!normal) return null;
  const su = surface.partial(u, v, 1, 0);
  const sv = surface.partial(u, v, 0, 1);
  return {
    E: dot(su, su),
    F: dot(su, sv),
    G: dot(sv, sv),
    L: dot(surface.partial(u, v, 2, 0), normal),
    M: dot(surface.partial(u, v, 1, 1), normal),
    N: dot(surface.partial(u, v, 0, 2), normal),
    normal,
  };
}

/** The curvatures of a surface at a point. */
export type SurfaceCurvature = {
  /** K = κ₁·κ₂: positive like a bowl, negative like a saddle, 0 if developable. Does not depend on the normal's side. */
  readonly gaussian: number;
  /** H = (κ₁ + κ₂)/2; positive where the surface bends towards its normal. */
  readonly mean: number;
  /** The principal curvatures κ₁ ≥ κ₂: the largest and the least curvature of normal sections. */
  readonly principal: readonly [number, number];
};

/**
 * The Gaussian, mean and principal curvatures of a surface in space, or `null` where it has no normal.
 *
 * K = (LN − M²)/(EG − F²), H = (EN − 2FM + GL)/(2(EG − F²)).
 */
export function surfaceCurvature(surface: Surface, u: number, v: number): SurfaceCurvature | null {
  const normal = surfaceNormal(surface, u, v);
  if (!normal) return null;
  const su = surface.partial(u, v, 1, 0);
  const sv = surface.partial(u, v, 0, 1);
  // All divided by the lengths √E and √G of the tangents, so that nothing over- or underflows: F becomes the cosine of
  // their angle, EG − F² the square of its sine.
  const [e, g] = [norm(su), norm(sv)];
  const cosine = dot(scale(su, 1 / e), scale(sv, 1 / g));
  const sine2 = norm(cross(scale(su, 1 / e), scale(sv, 1 / g))) ** 2;
  const l = dot(surface.partial(u, v, 2, 0), normal) / e / e;
  const m = dot(surface.partial(u, v, 1, 1), normal) / e / g;
  const n = dot(surface.partial(u, v, 0, 2), normal) / g / g;
  const gaussian = (l * n - m * m) / sine2;
  const mean = (l + n - 2 * cosine * m) / (2 * sine2);
  const spread = Math.sqrt(Math.max(0, mean * mean - gaussian));
  return { gaussian, mean, principal: [mean + spread, mean - spread] };
}
