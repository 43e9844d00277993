import type { Mesh, Variable } from '../../wasm/types.ts';
import { localOrigin, type Origin } from './gltf/local-origin.ts';
import type { Format, WriteOptions } from './surface.ts';
import { byRole } from './variables/roles.ts';

const singlePrecision: ReadonlySet<Format> = new Set<Format>(['glb', 'stl']);

/** Where a file of this format measures places from. */
export function originIn(format: Format, mesh: Mesh): Origin {
  return format === 'glb' ? localOrigin(mesh) : [0, 0, 0];
}

/**
 * The largest distance by which a file of this format moves a value, in the variable's unit: of position, then of the mesh's
 * variables. Only corners of triangles count; a point of a triangle moves by no more than its corners do. PLY, VTP, VTK and
 * OBJ hold every number as it is.
 */
export function roundingsOf(
  format: Format,
  mesh: Mesh,
  options: Pick<WriteOptions, 'origin' | 'roles'> = {},
): number[] {
  const position = { name: 'position', components: 3, values: mesh.position };
  const variables: Variable[] = [position, ...mesh.variables];
  if (!singlePrecision.has(format)) return variables.map(() => 0);
  const texture = format === 'glb' ? byRole(mesh.variables, options).get('textureCoordinates') : undefined;
  return variables.map((variable, i) => {
    const origin = i === 0 ? (options.origin ?? originIn(format, mesh)) : [];
    return largestRounding(variable, mesh.triangles, variable === texture ? topEdge : origin);
  });
}

/** From where GLB measures v, the second texture coordinate. */
const topEdge = [0, 1];

/** `origin`: by component what values are measured from; 0 where there is nothing. */
function largestRounding({ values, components }: Variable, corners: Uint32Array, origin: readonly number[]): number {
  if (values instanceof Float32Array && origin.every((from) => from === 0)) return 0;
  let largest = 0;
  for (const corner of corners) {
    let square = 0;
    for (let i = 0; i < components; i++) {
      const value = values[corner * components + i];
      const from = origin[i] ?? 0;
      const difference = from + Math.fround(value - from) - value;
      square += difference * difference;
    }
    // NaN, and what is beyond single precision, is refused where it is written.
    if (square > largest) largest = square;
  }
  return Math.sqrt(largest);
}
