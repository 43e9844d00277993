import type { Mesh } from '../../wasm/types.ts';
import { boundaryVertices } from '../surface/topology.ts';
import type { Surface } from './surface.ts';
import { gather, sharedPlaces } from './weld.ts';
import { counted } from './wording.ts';

/**
 * For formats in which points are one only if they are one in the file: points on the rim of the surface that lie where others on
 * the rim do are locked, so that nothing gapes there later, and this is said. Points stay as many as the file has.
 */
export function withOpenSeams(surface: Surface): Surface {
  const seams = openSeams(surface.mesh);
  if (surface.locked || seams.length === 0) return surface;
  const note = `${counted(seams.length, 'point')} on seams, where several lie in one place, will stay as they are.`;
  return { ...surface, locked: seams, notes: [...surface.notes, note] };
}

function openSeams({ position, triangles }: Mesh): Uint32Array {
  const shared = sharedPlaces(position);
  if (shared.length === 0) return shared;
  const onRim = boundaryVertices(triangles, position.length / 3);
  const rim = shared.filter((point) => onRim[point] === 1);
  return sharedPlaces(gather(position, 3, rim)).map((index) => rim[index]);
}
