import {
  bezierPatch,
  type ControlNet,
  limitNormal,
  patchIsoCurve,
  patchPartial,
  surfaceCurvature,
  surfaceNormal,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";

type Patch = { controlPoints: ControlNet };
type Places = { uv: [number, number][] };

export const adapter: Adapter = {
  surfaceEvaluate: ({
    controlPoints,
    uv,
    derivative,
  }: Patch & Places & { derivative: [number, number] }) => ({
    values: uv.map(([u, v]) => patchPartial(controlPoints, u, v, ...derivative)),
  }),
  surfaceNormal: ({ controlPoints, uv }: Patch & Places) => {
    const patch = bezierPatch(controlPoints);
    return {
      normals: uv.map(([u, v]) => surfaceNormal(patch, u, v)),
      limitNormals: uv.map(([u, v]) => limitNormal(patch, u, v)),
    };
  },
  surfaceCurvature: ({ controlPoints, uv }: Patch & Places) => {
    const patch = bezierPatch(controlPoints);
    const curvatures = uv.map(([u, v]) => surfaceCurvature(patch, u, v));
    return {
      gaussian: curvatures.map((c) => c?.gaussian),
      mean: curvatures.map((c) => c?.mean),
    };
  },
  surfaceIsoCurve: ({ controlPoints, fixed, value }: Patch & { fixed: "u" | "v"; value: number }) => ({
    controlPoints: patchIsoCurve(controlPoints, fixed, value),
  }),
};
