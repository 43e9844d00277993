import type { Mesh, Variable } from '../../wasm/types.ts';
import { type ColourRange, dataRange } from './colour-range.ts';

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

/** The range of a field over the vertices that triangles use. */
export function fieldRange(field: Field, triangles: Uint32Array): ColourRange {
  const used = new Float64Array(triangles.length);
  for (let corner = 0; corner < triangles.length; corner++) used[corner] = field[triangles[corner]];
  return dataRange(used);
}

/**
 * The place of each triangle corner in the range, 0…1: what a surface interpolates and looks up. Subtracting in double
 * precision first keeps a small variation on a large number visible.
 */
export function cornerPlaces(field: Field, triangles: Uint32Array, range: ColourRange): Float32Array {
  const places = new Float32Array(triangles.length);
  const width = range.highest - range.lowest;
  for (let corner = 0; corner < triangles.length; corner++) {
    places[corner] = width > 0 ? (field[triangles[corner]] - range.lowest) / width : 0.5;
  }
  return places;
}
