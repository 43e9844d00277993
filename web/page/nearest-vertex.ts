import type { Mesh } from '../../wasm/types.ts';

/** The vertex nearest to a place; of several, the first. */
export function nearestVertex({ position }: Mesh, place: readonly number[]): number {
  const distanceOf = (vertex: number) => Math.hypot(...place.map((at, axis) => at - position[3 * vertex + axis]));
  let [nearest, least] = [0, distanceOf(0)];
  for (let vertex = 1; vertex < position.length / 3; vertex++) {
    const distance = distanceOf(vertex);
    if (distance < least) [nearest, least] = [vertex, distance];
  }
  return nearest;
}
