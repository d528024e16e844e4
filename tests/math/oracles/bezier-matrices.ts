import {
  type BasisName,
  basisMatrix,
  conversionMatrix,
  convertBasis,
  exactBasisMatrix,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Pair = { from: BasisName; to: BasisName };

export const adapter: Adapter = {
  basisMatrix: ({ basis }: { basis: BasisName }) => ({
    matrix: basisMatrix(basis),
    ...exactBasisMatrix(basis),
  }),
  conversionMatrix: ({ from, to }: Pair) => ({ matrix: conversionMatrix(from, to) }),
  convertBasis: ({ from, to, geometry }: Pair & { geometry: Value[] }) => ({
    geometry: convertBasis(geometry.map(toPoint), from, to)?.map((row) => toValue(row, geometry[0]!)),
  }),
};
