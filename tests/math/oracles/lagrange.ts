import {
  barycentricWeights,
  dividedDifferences,
  interpolationNodes,
  lagrangeBasis,
  lagrangeBasisDerivative,
  lagrangeCurve,
  lagrangeFunction,
  maxError,
  maxErrorSampled,
  monomialCoefficients,
  type NodeKind,
  normalizeWeights,
  runge,
} from "../../../src/math/index.ts";
import type { Adapter } from "../oracle.ts";
import { toPoint, toValue, type Value } from "../scalar-or-point.ts";

type Nodes = { nodes: number[] };
type Data = Nodes & { values: Value[] };
type Family = { kind: NodeKind; a: number; b: number; degree: number };

const rungeInterpolant = ({ kind, a, b, degree }: Family) => {
  const nodes = interpolationNodes(kind, a, b, degree);
  return lagrangeFunction(nodes, nodes.map(runge));
};

export const adapter: Adapter = {
  nodes: ({ kind, a, b, degree }: Family) => ({ nodes: interpolationNodes(kind, a, b, degree) }),
  lagrangeBasis: ({ nodes, ts }: Nodes & { ts: number[] }) => ({
    values: ts.map((t) => lagrangeBasis(nodes, t)),
  }),
  lagrangeBasisDerivative: ({ nodes, ts }: Nodes & { ts: number[] }) => ({
    values: ts.map((t) => lagrangeBasisDerivative(nodes, t)),
  }),
  lagrangeInterpolate: ({ nodes, values, ts, derivative }: Data & { ts: number[]; derivative: number }) => {
    const curve = lagrangeCurve(nodes, values.map(toPoint));
    return { values: ts.map((t) => toValue(curve.derivative(t, derivative), values[0]!)) };
  },
  barycentricWeights: ({ nodes }: Nodes) => {
    const weights = barycentricWeights(nodes);
    return { weights, normalized: normalizeWeights(weights) };
  },
  dividedDifferences: ({ nodes, values }: Data) => ({
    coefficients: dividedDifferences(nodes, values.map(toPoint)).map((c) => toValue(c, values[0]!)),
  }),
  monomialCoefficients: ({ nodes, values }: Data) => ({
    coefficients: monomialCoefficients(nodes, values.map(toPoint)).map((c) => toValue(c, values[0]!)),
  }),
  rungeValues: (input: Family & { positions: number[] }) => {
    const p = rungeInterpolant(input);
    return { values: input.positions.map((x) => p(x)) };
  },
  rungeErrorSampled: (input: Family & { positions: number[] }) => ({
    maxError: maxErrorSampled(runge, rungeInterpolant(input), input.positions).error,
  }),
  rungeMaxError: (input: Family) => ({
    maxError: maxError(runge, rungeInterpolant(input), input.a, input.b).error,
  }),
};
