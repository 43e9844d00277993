import type { Mesh } from '../../wasm/types.ts';
import type { Correspondence } from './correspondence.ts';
import type { Multiplied } from './multiplied.ts';
import { distance, type Place, valuesAt, variablesOf } from './place.ts';

export type Side = 'original' | 'reduced';

/** A point of a surface, and where that is in space. */
export interface ProbedPlace extends Place {
  position: number[];
}

/** What a variable is at a place of both surfaces, in its unit. */
export interface ProbedVariable {
  name: string;
  /** Its components; null on a surface whose place is not known. */
  original: number[] | null;
  reduced: number[] | null;
  /**
   * The length of their difference; where errors are propagated, and the place is on the reduced surface, what it is at most
   * in the triangle there. Null where nothing is known of it, or it is no number.
   */
  error: number | null;
  /** As it is multiplied there; Infinity where it is free or nothing was reduced. */
  bound: number;
  /** error / bound, 0…1; null where there is no error or no bound. */
  ratio: number | null;
}

/** A place of a surface, and the same place on the other one. */
export interface Probe {
  /** The surface that was pointed at. */
  from: Side;
  /** Null on a surface where the place is not known: nothing was reduced, or errors were propagated, without a map. */
  original: ProbedPlace | null;
  reduced: ProbedPlace | null;
  /** Position first, then the variables in their order. */
  variables: ProbedVariable[];
  /** How many points of the original are mapped to this place of the reduced surface; more than one where the map folds. */
  preimages: number;
}

/** What is probed: a surface and what became of it. */
export interface Probed {
  mesh: Mesh;
  /** Null where nothing was reduced. */
  reduction: Multiplied | null;
  /** Null where there is no map. */
  correspondence: Correspondence | null;
}

/** What stands at a point of one of the surfaces, and at the same point of the other one. */
export function probeAt(probed: Probed, from: Side, place: Place): Probe {
  if (from === 'original') return probeOriginal(probed, place);
  const preimages = probed.correspondence?.preimages(place) ?? [];
  const probes = preimages.map((each) => probePair(probed, from, each, place, preimages.length));
  // Where several points are mapped to this one, it stands for the worst of them.
  if (probes.length > 0)
    return probes.reduce((worst, each) => (largestRatio(each) > largestRatio(worst) ? each : worst));
  return probePair(probed, from, null, place, 0);
}

function probeOriginal(probed: Probed, place: Place): Probe {
  const image = probed.correspondence?.image(place) ?? null;
  // A point of what was squeezed into a line counts, too.
  const preimages = image ? Math.max(1, probed.correspondence?.preimages(image).length ?? 0) : 0;
  return probePair(probed, 'original', place, image, preimages);
}

/** Of a pair of points that belong together. */
export function probePair(
  { mesh, reduction }: Probed,
  from: Side,
  original: Place | null,
  reduced: Place | null,
  preimages: number,
): Probe {
  const here = original && valuesOn(mesh, original);
  const there = reduction && reduced && valuesOn(reduction.mesh, reduced);
  const multiplier = original ? multiplierAt(mesh, reduction, original) : 1;
  return {
    from,
    original: original && here && { ...original, position: here[0] },
    reduced: reduced && there && { ...reduced, position: there[0] },
    variables: variablesOf(mesh).map(({ name }, index) => {
      const values = { original: here?.[index] ?? null, reduced: there?.[index] ?? null };
      const error = errorOf(values, reduction, index, reduced);
      const bound = multiplier * (reduction?.report.variables[index].bound ?? Infinity);
      const limit = reduced && !original ? reduction?.triangleErrors[index].ratio[reduced.triangle] : undefined;
      const ratio = error !== null && Number.isFinite(bound) ? (limit ?? error / bound) : null;
      return { name, ...values, error, bound, ratio };
    }),
    preimages,
  };
}

function multiplierAt({ triangles }: Mesh, reduction: Multiplied | null, place: Place): number {
  if (!reduction?.multiplier) return 1;
  const variable = { name: '', components: 1, values: reduction.multiplier };
  return valuesAt(variable, triangles, place)[0];
}

function valuesOn(mesh: Mesh, place: Place): number[][] {
  return variablesOf(mesh).map((variable) => valuesAt(variable, mesh.triangles, place));
}

function errorOf(
  { original, reduced }: Pick<ProbedVariable, 'original' | 'reduced'>,
  reduction: Multiplied | null,
  index: number,
  place: Place | null,
): number | null {
  const between = original && reduced && distance(original, reduced);
  const error = between ?? (place && reduction ? reduction.triangleErrors[index].largest[place.triangle] : null);
  return error !== null && Number.isFinite(error) ? error : null;
}

/** The variable that has the largest share of its bound there; null where none is known. */
export function largestShare({ variables }: Probe): ProbedVariable | null {
  const known = variables.filter(({ ratio }) => ratio !== null);
  return known.reduce<ProbedVariable | null>(
    (most, each) => (!most || (each.ratio ?? 0) > (most.ratio ?? 0) ? each : most),
    null,
  );
}

function largestRatio(probe: Probe): number {
  return largestShare(probe)?.ratio ?? 0;
}
