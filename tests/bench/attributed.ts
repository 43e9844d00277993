import { extent } from 'd3-array';
import { MeshoptSimplifier } from 'meshoptimizer';
import type { Mesh } from '../../wasm/types.ts';
import { bounds } from './cases.ts';

/** A mesh as meshoptimizer takes it. */
export interface Attributed {
  triangles: Uint32Array;
  position: Float32Array;
  /** One row a vertex. */
  attributes: Float32Array;
  /** One a variable: an error of one bound in it weighs as much as one of one bound in position. */
  weights: number[];
}

export function attributed({ triangles, position, variables }: Mesh): Attributed {
  const vertices = position.length / 3;
  const attributes = new Float32Array(vertices * variables.length);
  for (const [column, { values }] of variables.entries()) {
    for (let vertex = 0; vertex < vertices; vertex++) {
      attributes[vertex * variables.length + column] = values[vertex] as number;
    }
  }
  const single = position as Float32Array;
  // Inside, positions are divided by this scale, and attributes are multiplied by their weights.
  const positionBound = (bounds.position.relative * diagonal(single)) / MeshoptSimplifier.getScale(single, 3);
  const weights = variables.map(({ values }) => positionBound / (bounds['*'].relative * range(values)));
  return { triangles, position: single, attributes, weights };
}

function range(values: Iterable<number>): number {
  const [lowest = 0, highest = 0] = extent(values);
  return highest - lowest || 1;
}

function diagonal(position: Float32Array): number {
  const sides = [0, 1, 2].map((axis) => range(position.filter((_, index) => index % 3 === axis)));
  return Math.hypot(...sides);
}
