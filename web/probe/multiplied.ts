import type { Reduction, Variable } from '../../wasm/types.ts';

/** A reduction whose bounds were multiplied, where it has a multiplier: one number for each vertex of the original. */
export type Multiplied = Reduction & { multiplier?: Variable['values'] };

/**
 * Error / bound of a variable at the vertices of the original, the bound multiplied as it is there; null where the errors are
 * not known (propagated). Zero where the variable is free.
 *
 * @param index 0 for position, then the variables in their order
 */
export function vertexShares({ vertexErrors, report, multiplier }: Multiplied, index: number): Float64Array | null {
  if (!vertexErrors) return null;
  const { bound } = report.variables[index];
  return Float64Array.from(vertexErrors[index].error, (error, vertex) => error / (bound * (multiplier?.[vertex] ?? 1)));
}
