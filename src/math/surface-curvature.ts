import { dot, type Point } from "./point.ts";
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
  const forms = fundamentalForms(surface, u, v);
  if (!forms) return null;
  const { E, F, G, L, M, N } = forms;
  // F/√(EG) is the cosine of the angle between the tangents; scaling by the lengths keeps EG − F² from overflowing.
  const [e, g] = [Math.sqrt(E), Math.sqrt(G)];
  const cosine = F / e / g;
  const sine2 = (1 - cosine) * (1 + cosine);
  const [l, m, n] = [L / E, M / e / g, N / G];
  const gaussian = (l * n - m * m) / sine2;
  const mean = (l + n - 2 * cosine * m) / (2 * sine2);
  const spread = Math.sqrt(Math.max(0, mean * mean - gaussian));
  return { gaussian, mean, principal: [mean + spread, mean - spread] };
}
