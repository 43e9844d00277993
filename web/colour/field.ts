import type { Mesh, Variable } from '../../wasm/types.ts';
import { usedPoints } from '../surface/used-points.ts';
import { type ColourRange, dataRange, placeIn } from './colour-range.ts';
import { missingPlace } from './missing-place.ts';

/** What of a variable is shown: one of its components, counted from 0, or the Euclidean norm of them all. */
export type Component = number | 'magnitude';

/** One number a vertex, in the variable's unit. */
export type Field = Float32Array | Float64Array;

const cartesian = ['x', 'y', 'z'];

/**
 * The components of a variable that can be shown, with what to call them; a scalar has only one.
 *
 * @param names what the file calls them, one each, where it does
 */
export function componentsOf(components: number, names?: readonly string[]): { component: Component; label: string }[] {
  if (components === 1) return [{ component: 0, label: 'value' }];
  const usual = components <= cartesian.length ? cartesian : [];
  const named = Array.from({ length: components }, (_, index) => ({
    component: index as Component,
    label: names?.[index] ?? usual[index] ?? String(index + 1),
  }));
  return [{ component: 'magnitude', label: 'magnitude' }, ...named];
}

/** `position` as a variable among the others, so that geometry and data share one path. */
export function allVariables(mesh: Mesh): Variable[] {
  return [{ name: 'position', components: 3, values: mesh.position }, ...mesh.variables];
}

export function fieldOf(variable: Variable, component: Component): Field {
  const { components, values } = variable;
  if (components === 1) return values;
  const field = new Float64Array(values.length / components);
  for (let vertex = 0; vertex < field.length; vertex++) {
    const first = vertex * components;
    field[vertex] = component === 'magnitude' ? norm(values, first, first + components) : values[first + component];
  }
  return field;
}

function norm(values: ArrayLike<number>, begin: number, end: number): number {
  let squares = 0;
  for (let index = begin; index < end; index++) squares += values[index] ** 2;
  return Math.sqrt(squares);
}

/** A field's values at the vertices that triangles use, once each. */
export function usedValues(field: Field, triangles: Uint32Array): Float64Array {
  const used = usedPoints(triangles, field.length);
  return Float64Array.from(field).filter((_, vertex) => used[vertex] === 1);
}

/** The range of a field over the vertices that triangles use. */
export function fieldRange(field: Field, triangles: Uint32Array): ColourRange {
  return dataRange(usedValues(field, triangles));
}

/**
 * The place of each triangle corner in the range, what a surface interpolates and looks up: 0…1, below 0 and above 1 where
 * the range does not hold the value, `missingPlace` at all corners of a triangle that has a corner without a number.
 * Subtracting in double precision first keeps a small variation on a large number visible.
 */
export function cornerPlaces(field: Field, triangles: Uint32Array, range: ColourRange): Float32Array {
  const places = new Float32Array(triangles.length);
  for (let first = 0; first < triangles.length; first += 3) {
    const values = [0, 1, 2].map((corner) => field[triangles[first + corner]]);
    if (!values.every(Number.isFinite)) places.fill(missingPlace, first, first + 3);
    else for (let corner = 0; corner < 3; corner++) places[first + corner] = placeIn(range, values[corner]);
  }
  return places;
}
