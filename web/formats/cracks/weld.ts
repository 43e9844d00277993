import type { Mesh, Variable } from '../../../wasm/types.ts';

type Values = Float32Array | Float64Array;
const none = 0xffffffff;

/** What became of points that lie in the same place. */
export interface Weld {
  mesh: Mesh;
  /** How many points went because another one is the same in place and all variables. */
  welded: number;
}

/**
 * Makes one point of all that agree in place and in every variable, exactly. The first of them stays, order is kept.
 * Formats for drawing repeat a point for every triangle or every normal; to them a mesh is a heap of loose triangles.
 */
export function weld(mesh: Mesh): Weld {
  const rows = [{ values: mesh.position, components: 3 }, ...mesh.variables];
  const same = firstOfEqual(rows, mesh.position.length / 3);
  const joined = withoutRepeated(mesh, same);
  return { mesh: joined, welded: (mesh.position.length - joined.position.length) / 3 };
}

/** The mesh without points that are the same as another one: `same` says which, for each point; those that stay name themselves. */
export function withoutRepeated(mesh: Mesh, same: Uint32Array): Pick<Mesh, 'position' | 'triangles' | 'variables'> {
  const kept = same.filter((first, point) => first === point);
  const renumbered = new Uint32Array(same.length);
  for (const [index, point] of kept.entries()) renumbered[point] = index;
  const position = gather(mesh.position, 3, kept);
  const variables = mesh.variables.map(
    (variable): Variable => ({ ...variable, values: gather(variable.values, variable.components, kept) }),
  );
  const triangles = mesh.triangles.map((corner) => renumbered[same[corner]]);
  return { position, triangles, variables };
}

/** For each point the first one in the same place. */
export function placesOf(position: Values): Uint32Array {
  return firstOfEqual([{ values: position, components: 3 }], position.length / 3);
}

type Row = Pick<Variable, 'values' | 'components'>;

/** For each row of numbers, a point or whatever has them, the first one that is the same: 0 and −0 are, and NaN is like NaN. */
export function firstOfEqual(rows: Row[], points: number): Uint32Array {
  // Open addressing, at most half full.
  const size = 2 ** Math.ceil(Math.log2(2 * points + 2));
  const table = new Uint32Array(size).fill(none);
  const first = new Uint32Array(points);
  for (let point = 0; point < points; point++) {
    let slot = hash(rows, point) & (size - 1);
    while (table[slot] !== none && !areEqual(rows, table[slot], point)) slot = (slot + 1) & (size - 1);
    if (table[slot] === none) table[slot] = point;
    first[point] = table[slot];
  }
  return first;
}

const scratch = new Float64Array(1);
const halves = new Uint32Array(scratch.buffer);

function hash(rows: Row[], point: number): number {
  let mixed = 0;
  for (const { values, components } of rows) {
    for (let i = point * components; i < (point + 1) * components; i++) {
      // Adding 0 makes 0 of −0.
      scratch[0] = values[i] + 0;
      mixed = Math.imul(mixed ^ halves[0], 0x9e3779b1);
      mixed = Math.imul(mixed ^ (mixed >>> 15) ^ halves[1], 0x85ebca77);
      mixed ^= mixed >>> 13;
    }
  }
  return mixed >>> 0;
}

function areEqual(rows: Row[], a: number, b: number): boolean {
  return rows.every(({ values, components }) => {
    for (let i = 0; i < components; i++) {
      const [x, y] = [values[a * components + i], values[b * components + i]];
      if (x !== y && !(Number.isNaN(x) && Number.isNaN(y))) return false;
    }
    return true;
  });
}

/** The values of these points, in their order. */
export function gather(values: Values, components: number, points: Uint32Array): Values {
  const kept =
    values instanceof Float64Array
      ? new Float64Array(points.length * components)
      : new Float32Array(points.length * components);
  for (let to = 0; to < points.length; to++) {
    for (let i = 0; i < components; i++) kept[to * components + i] = values[points[to] * components + i];
  }
  return kept;
}
