import { MeshboundError } from './errors.ts';
import type { Mesh, SurfaceMap, Variable } from './types.ts';

/** Throws a TypeError for values that are in no array of floating-point numbers. */
export function checkValues(values: unknown, what: string): void {
  if (!(values instanceof Float32Array || values instanceof Float64Array)) {
    throw new TypeError(`The ${what} must be a Float32Array or a Float64Array.`);
  }
}

/** The same for what is no plain list of numbers. */
export function checkNumbers(numbers: unknown, what: string): void {
  if (!Array.isArray(numbers) || !numbers.every((each) => typeof each === 'number')) {
    throw new TypeError(`The ${what} must be an array of numbers.`);
  }
}

function checkKind(kind: unknown, name: string): void {
  if (kind !== undefined && kind !== 'quantity' && kind !== 'identifier') {
    throw new TypeError(`The kind of “${name}” must be 'quantity' or 'identifier'.`);
  }
}

function checkTriangles(triangles: unknown): void {
  if (!(triangles instanceof Uint32Array)) {
    throw new TypeError('The triangles must be a Uint32Array.');
  }
  if (triangles.length % 3 !== 0) {
    const message = `The triangles hold ${triangles.length} indices, which is not a multiple of three.`;
    throw new MeshboundError({ code: 'bad_index', message, index: Math.floor(triangles.length / 3) });
  }
}

/** Throws a TypeError for arrays of another type than `Mesh` says; everything else is the core's to judge. */
export function checkMesh({ position, triangles, variables, regions }: Mesh): void {
  checkValues(position, 'position');
  checkTriangles(triangles);
  if (regions !== undefined && !(regions instanceof Int32Array)) {
    throw new TypeError('The regions must be an Int32Array.');
  }
  for (const { name, values, kind } of variables) {
    checkValues(values, `values of “${name}”`);
    checkKind(kind, name);
  }
}

/** The same of what says where the vertices of a reduced mesh come from. */
export function checkVertices(vertices: unknown): void {
  if (!(vertices instanceof Uint32Array)) throw new TypeError('The vertices must be a Uint32Array.');
}

const mapArrays = {
  triangle: Uint32Array,
  barycentric: Float64Array,
  crossingEdges: Uint32Array,
  crossingShares: Float64Array,
  crossingRightward: Uint8Array,
} as const;

/** The same of a map. */
export function checkMap(map: SurfaceMap): void {
  for (const [name, type] of Object.entries(mapArrays)) {
    if (!(map[name as keyof SurfaceMap] instanceof type)) {
      throw new TypeError(`The map's ${name} must be a ${type.name}.`);
    }
  }
}

/** A copy whose buffers are its own, so that they can be transferred while the caller's stay as they are. */
export function copyMesh({ position, triangles, variables, regions }: Mesh): Mesh {
  const copyVariable = (variable: Variable) => ({
    name: variable.name,
    components: variable.components,
    kind: variable.kind,
    values: variable.values.slice(),
  });
  const copy = { position: position.slice(), triangles: triangles.slice(), variables: variables.map(copyVariable) };
  return regions ? { ...copy, regions: regions.slice() } : copy;
}

/** The same of a map. */
export function copyMap(map: SurfaceMap): SurfaceMap {
  return {
    triangle: map.triangle.slice(),
    barycentric: map.barycentric.slice(),
    crossingEdges: map.crossingEdges.slice(),
    crossingShares: map.crossingShares.slice(),
    crossingRightward: map.crossingRightward.slice(),
  };
}
