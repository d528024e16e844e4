import { bezierCurve, classifyJoint, type Point } from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";

export const adapter: Adapter = {
  joinClassify: ({ a, b }: { a: Point[]; b: Point[] }) => classifyJoint(bezierCurve(a), bezierCurve(b)),
};
