import { reduce, verify } from '../../wasm/index.ts';
import type { Bound, Mesh, ReduceOptions, VariableReport } from '../../wasm/types.ts';

export type Errors = NonNullable<ReduceOptions['errors']>;
export type Bounds = Record<string, Bound>;

/** What came of one reduction, and what the judge says of it. */
export interface Outcome {
  triangles: number;
  /** Position first, then the mesh's variables in their order. */
  variables: VariableReport[];
  /** The judge's ratio of surface and boundary, all bounds together: at most 1. */
  judged: number;
}

/** An outcome with the error of each variable that the judge sees, as a ratio to its bound. */
export interface DetailedOutcome extends Outcome {
  judgedErrors: number[];
}

/** The judge's errors are found by bisection, to this fraction of the bound. */
const resolution = 1 / 128;

/** Reduces and has the result judged; throws where the judge finds a bound broken. */
export async function outcomeOf(mesh: Mesh, bounds: Bounds, errors: Errors): Promise<Outcome> {
  return (await judgedReduction(mesh, bounds, errors)).outcome;
}

export async function detailedOutcomeOf(mesh: Mesh, bounds: Bounds, errors: Errors): Promise<DetailedOutcome> {
  const { reduced, outcome } = await judgedReduction(mesh, bounds, errors);
  const limits = outcome.variables.map(({ bound }) => bound);
  const judgedErrors: number[] = [];
  for (const variable of limits.keys()) judgedErrors.push(await judgedError(mesh, reduced, limits, variable));
  return { ...outcome, judgedErrors };
}

async function judgedReduction(mesh: Mesh, bounds: Bounds, errors: Errors) {
  const { mesh: reduced, report } = await reduce(mesh, { bounds, errors, countFolds: false });
  const { triangles, variables } = report;
  const limits = variables.map(({ bound }) => bound);
  const { ratio: judged, withinBounds } = await verify(mesh, reduced, { bounds: limits });
  if (!withinBounds) throw new Error(`The judge finds a bound broken: ${judged}.`);
  return { reduced, outcome: { triangles: triangles.after, variables, judged } };
}

/** The smallest fraction of one variable's bound at which the judge still passes, all other bounds being as they are. */
async function judgedError(mesh: Mesh, reduced: Mesh, limits: number[], variable: number): Promise<number> {
  let [low, high] = [0, 1];
  while (high - low > resolution) {
    const middle = (low + high) / 2;
    const tried = limits.map((limit, i) => (i === variable ? middle * limit : limit));
    if ((await verify(mesh, reduced, { bounds: tried })).withinBounds) high = middle;
    else low = middle;
  }
  return high;
}
