import type { Mesh, Variable } from '../../wasm/types.ts';

/** Barycentric coordinates in a triangle: 0…1, sum 1. */
export type Shares = readonly [number, number, number];

/** A point of a surface. */
export interface Place {
  triangle: number;
  /** Shares of the triangle's three corners. */
  barycentric: Shares;
}

/** Position, then the variables of a mesh, in their order. */
export function variablesOf({ position, variables }: Mesh): Variable[] {
  return [{ name: 'position', components: 3, values: position }, ...variables];
}

/** The components of a variable at a place, in its unit: linear on the triangle. */
export function valuesAt({ components, values }: Variable, triangles: Uint32Array, place: Place): number[] {
  const { triangle, barycentric } = place;
  return Array.from({ length: components }, (_, component) => {
    let sum = 0;
    for (let corner = 0; corner < 3; corner++) {
      // A share of nothing takes nothing, so that a vertex has its own value, bit for bit.
      if (barycentric[corner] === 0) continue;
      sum += barycentric[corner] * values[triangles[3 * triangle + corner] * components + component];
    }
    return sum;
  });
}

/** The length of the difference: the error of a variable with these components here and there. */
export function distance(one: readonly number[], other: readonly number[]): number {
  return Math.hypot(...one.map((value, component) => value - other[component]));
}

/** The direction in which a triangle faces, twice as long as its area. */
export function normalOf({ position, triangles }: Mesh, triangle: number): [x: number, y: number, z: number] {
  const a = 3 * triangles[3 * triangle];
  const b = 3 * triangles[3 * triangle + 1];
  const c = 3 * triangles[3 * triangle + 2];
  const edge = (to: number, axis: number) => position[to + axis] - position[a + axis];
  const part = (i: number, j: number) => edge(b, i) * edge(c, j) - edge(b, j) * edge(c, i);
  return [part(1, 2), part(2, 0), part(0, 1)];
}
