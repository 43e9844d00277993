import type { Mesh } from '../../../wasm/types.ts';
import { usedPoints } from '../../surface/used-points.ts';

/** The vertex nearest to a place, of those that triangles use; of several, the first. */
export function nearestVertex({ position, triangles }: Mesh, place: readonly number[]): number {
  const used = usedPoints(triangles, position.length / 3);
  const distanceOf = (vertex: number) => Math.hypot(...place.map((at, axis) => at - position[3 * vertex + axis]));
  let [nearest, least] = [0, Infinity];
  for (let vertex = 0; vertex < used.length; vertex++) {
    if (!used[vertex]) continue;
    const distance = distanceOf(vertex);
    if (distance < least) [nearest, least] = [vertex, distance];
  }
  return nearest;
}
