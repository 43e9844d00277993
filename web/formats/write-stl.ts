import type { Mesh } from '../../wasm/types.ts';
import { FormatError } from './format-error.ts';

const headSize = 84;
const facetSize = 50;
const mostFacets = 2 ** 32 - 1;

/** Writes a binary STL file: places in single precision, normals from the corners, no variables at all. */
export function writeStl(mesh: Mesh): Uint8Array {
  const facets = mesh.triangles.length / 3;
  if (facets > mostFacets) throw new FormatError('too_large', 'STL counts its facets in 32 bits; the mesh has more.');
  const file = new Uint8Array(headSize + facetSize * facets);
  // Not “solid”, by which text is told.
  file.set(new TextEncoder().encode('written by Meshbound'));
  const view = new DataView(file.buffer);
  view.setUint32(headSize - 4, facets, true);
  for (let facet = 0; facet < facets; facet++) {
    const corners = mesh.triangles.subarray(3 * facet, 3 * facet + 3);
    const places = Array.from(corners, (corner) => Array.from(mesh.position.subarray(3 * corner, 3 * corner + 3)));
    for (const [i, number] of [normalOf(places), ...places].flat().entries()) {
      view.setFloat32(headSize + facetSize * facet + 4 * i, number, true);
    }
  }
  return file;
}

/** Of unit length, by the right-hand rule; zero for a triangle without area. */
function normalOf([a, b, c]: number[][]): number[] {
  const [u, v] = [b, c].map((end) => end.map((coordinate, axis) => coordinate - a[axis]));
  const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...normal);
  return length > 0 ? normal.map((part) => part / length) : [0, 0, 0];
}
