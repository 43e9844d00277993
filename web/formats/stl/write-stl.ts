import type { Mesh } from '../../../wasm/types.ts';
import { FormatError } from '../format-error.ts';

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
  for (let facet = 0; facet < facets; facet++) writeFacet(view, headSize + facetSize * facet, mesh, facet);
  return file;
}

const normal = new Float64Array(3);

function writeFacet(view: DataView, start: number, { position, triangles }: Mesh, facet: number): void {
  const [a, b, c] = [3 * triangles[3 * facet], 3 * triangles[3 * facet + 1], 3 * triangles[3 * facet + 2]];
  setNormal(position, a, b, c);
  for (let axis = 0; axis < 3; axis++) {
    view.setFloat32(start + 4 * axis, normal[axis], true);
    view.setFloat32(start + 4 * (3 + axis), position[a + axis], true);
    view.setFloat32(start + 4 * (6 + axis), position[b + axis], true);
    view.setFloat32(start + 4 * (9 + axis), position[c + axis], true);
  }
}

/** Of unit length, by the right-hand rule; zero for a triangle without area. */
function setNormal(position: Mesh['position'], a: number, b: number, c: number): void {
  const [ax, ay, az] = [position[a], position[a + 1], position[a + 2]];
  const [ux, uy, uz] = [position[b] - ax, position[b + 1] - ay, position[b + 2] - az];
  const [vx, vy, vz] = [position[c] - ax, position[c + 1] - ay, position[c + 2] - az];
  normal[0] = uy * vz - uz * vy;
  normal[1] = uz * vx - ux * vz;
  normal[2] = ux * vy - uy * vx;
  const length = Math.hypot(normal[0], normal[1], normal[2]) || 1;
  for (let axis = 0; axis < 3; axis++) normal[axis] /= length;
}
