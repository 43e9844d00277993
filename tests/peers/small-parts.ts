import { writeFileSync } from 'node:fs';
import { join } from 'node:path';

import type { Mesh } from '../../wasm/types.ts';
import { writePly } from '../../web/formats/ply/write-ply.ts';
import type { Peer, Task } from './peer.ts';
import { places } from './places.ts';
import { readScalars } from './surfaces.ts';

/** A connected part with no more than this share of the triangles is small. */
const smallShare = 0.002;

/** Small parts collapse to nothing in most peers, which the judge never passes; so a careful user would keep them out of it. */
export function hasSmallParts(mesh: Mesh): boolean {
  return split(mesh).small.triangles.length > 0;
}

/** The same peer, given the surface without its small parts, which are added to the result as they are. */
export function withoutSmallParts(peer: Peer): Peer {
  return {
    ...peer,
    async open(task: Task) {
      const { large, small } = split(task.mesh);
      const path = join(places.cache, `large-parts-${process.pid}.ply`);
      writeFileSync(path, writePly(large));
      const simplify = await peer.open({ ...task, path, mesh: large });
      return async (setting, target, output) => {
        const smallTriangles = small.triangles.length / 3;
        await simplify(setting, Math.max(1, target - smallTriangles), output);
        const result = joined(readScalars(output), small);
        writeFileSync(output, writePly(result));
        return result.triangles.length / 3;
      };
    },
  };
}

function split(mesh: Mesh): { large: Mesh; small: Mesh } {
  const roots = partOfVertices(mesh);
  const sizes = new Map<number, number>();
  for (let i = 0; i < mesh.triangles.length; i += 3) {
    const root = roots[mesh.triangles[i]];
    sizes.set(root, (sizes.get(root) ?? 0) + 1);
  }
  const most = (smallShare * mesh.triangles.length) / 3;
  const isSmall = (vertex: number) => (sizes.get(roots[vertex]) ?? 0) <= most;
  return { large: only(mesh, (vertex) => !isSmall(vertex)), small: only(mesh, isSmall) };
}

/** For each vertex one that stands for its connected part. */
function partOfVertices({ position, triangles }: Mesh): Uint32Array {
  const parents = Uint32Array.from({ length: position.length / 3 }, (_, vertex) => vertex);
  const root = (vertex: number): number => {
    let at = vertex;
    while (parents[at] !== at) at = parents[at] = parents[parents[at]];
    return at;
  };
  for (let i = 0; i < triangles.length; i++) parents[root(triangles[i])] = root(triangles[i - (i % 3)]);
  return parents.map((_, vertex) => root(vertex));
}

/** The vertices that `keep` names, and their triangles. */
function only(mesh: Mesh, keep: (vertex: number) => boolean): Mesh {
  const places = new Map<number, number>();
  for (let vertex = 0; vertex < mesh.position.length / 3; vertex++) if (keep(vertex)) places.set(vertex, places.size);
  const kept = [...places.keys()];
  return {
    position: Float32Array.from(kept.flatMap((vertex) => [...mesh.position.subarray(3 * vertex, 3 * vertex + 3)])),
    triangles: mesh.triangles.filter((vertex) => places.has(vertex)).map((vertex) => places.get(vertex) ?? 0),
    variables: mesh.variables.map((variable) => ({
      ...variable,
      values: Float32Array.from(kept, (vertex) => variable.values[vertex]),
    })),
  };
}

/** Both as one mesh, with the variables of the first. */
function joined(one: Mesh, other: Mesh): Mesh {
  const shift = one.position.length / 3;
  return {
    position: Float32Array.from([...one.position, ...other.position]),
    triangles: Uint32Array.from([...one.triangles, ...other.triangles.map((vertex) => vertex + shift)]),
    variables: one.variables.map((variable, index) => ({
      ...variable,
      values: Float32Array.from([...variable.values, ...other.variables[index].values]),
    })),
  };
}
