import type { Mesh, Reduction, Variable } from '../../../wasm/index.ts';
import { type Labels, noLabels } from '../surface.ts';
import { asFloatingPoint } from './precision.ts';

export const triangleName = 'reduced_triangle';
const barycentricName = 'reduced_barycentric';

/** What the map gives to vertices that no triangle uses: they have no place. */
const nowhere = 0xffffffff;

function errorNames(name: string): { error: string; signedError: string } {
  return { error: `${name}_error`, signedError: `${name}_signed_error` };
}

/** The names of variables of the surface that the map needs for itself. */
export function takenMapNames(mesh: Mesh): string[] {
  const names = ['position', ...mesh.variables.map(({ name }) => name)];
  const needed = new Set([triangleName, barycentricName, ...names.flatMap((name) => Object.values(errorNames(name)))]);
  return names.filter((name) => needed.has(name));
}

/**
 * The original with where each vertex went, and what error it has there, as variables:
 *
 * - `reduced_triangle`: the triangle of the reduced surface in which it lies, counted from 0; −1 where no triangle uses it;
 * - `reduced_barycentric`: its three barycentric coordinates in that triangle;
 * - `NAME_error`: the error of each variable, `position` among them, in its unit;
 * - `NAME_signed_error`: original minus reduced, of scalars; of `position` the distance along the normal,
 *   positive where the reduced surface lies outside.
 */
export function withMap(original: Mesh, { map, vertexErrors }: Reduction): Mesh {
  if (!map || !vertexErrors) throw new Error('The reduction gave no map.');
  const triangle = Float64Array.from(map.triangle, (each) => (each === nowhere ? -1 : each));
  const variables: Variable[] = [
    { name: triangleName, components: 1, values: asFloatingPoint(triangle) },
    { name: barycentricName, components: 3, values: map.barycentric },
  ];
  const names = ['position', ...original.variables.map(({ name }) => name)];
  for (const [i, name] of names.entries()) {
    const { error, signedError } = vertexErrors[i];
    variables.push({ name: errorNames(name).error, components: 1, values: error });
    if (signedError.length > 0)
      variables.push({ name: errorNames(name).signedError, components: 1, values: signedError });
  }
  return { ...original, variables: [...original.variables, ...variables] };
}

/** The labels of the original with those of what withMap adds: errors have the unit of their variable. */
export function labelsWithMap<Named extends Labels>({ units, ...rest }: Named): Omit<Named, 'units'> & Labels {
  const all = Object.assign(noLabels().units, units);
  for (const [name, unit] of Object.entries(units)) {
    for (const error of Object.values(errorNames(name))) all[error] = unit;
  }
  return { ...rest, componentNames: rest.componentNames, units: all };
}
