import type { Mesh } from '../../wasm/types.ts';

/** Vertices around which triangles have more than one label. */
function mixedVertices({ position, triangles }: Mesh, regions: Int32Array): Uint8Array {
  const label = new Int32Array(position.length / 3);
  const [seen, mixed] = [new Uint8Array(label.length), new Uint8Array(label.length)];
  triangles.forEach((vertex, corner) => {
    const here = regions[Math.floor(corner / 3)];
    if (seen[vertex] && label[vertex] !== here) mixed[vertex] = 1;
    seen[vertex] = 1;
    label[vertex] = here;
  });
  return mixed;
}

/** The edges between triangles of different labels, each once, as the places of their two ends: six numbers an edge. */
export function regionBorders(mesh: Mesh, regions: Int32Array): Float64Array {
  const { position, triangles } = mesh;
  const mixed = mixedVertices(mesh, regions);
  const labels = new Map<number, number>();
  const ends: number[] = [];
  for (let corner = 0; corner < triangles.length; corner++) {
    const next = corner % 3 === 2 ? corner - 2 : corner + 1;
    const [one, other] = [triangles[corner], triangles[next]];
    if (!mixed[one] || !mixed[other]) continue;
    const [low, high] = [Math.min(one, other), Math.max(one, other)];
    const edge = (low * position.length) / 3 + high;
    const here = regions[Math.floor(corner / 3)];
    const there = labels.get(edge) ?? here;
    // No label is NaN, which differs from itself: such an edge is there already.
    if (there !== here && !Number.isNaN(there)) ends.push(low, high);
    labels.set(edge, there === here ? here : Number.NaN);
  }
  const places = new Float64Array(3 * ends.length);
  for (const [i, vertex] of ends.entries()) places.set(position.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
  return places;
}
