import type { Mesh } from '../../../wasm/types.ts';
import { Partition } from '../../surface/partition.ts';
import { sheetEnds } from '../../surface/topology.ts';
import type { Surface } from '../surface.ts';
import { counted } from '../text/wording.ts';
import { firstOfEqual, placesOf } from './weld.ts';

/**
 * Points stay as many as the reader left, though several lie in one place. Where sheets end along the same edges, such a place
 * is on a seam: the core reduces it on all sides together, and this is said. Where the end of a sheet only touches another one,
 * points are locked, so that nothing gapes there later.
 */
export function withOpenSeams(surface: Surface): Surface {
  const { seams, touching } = contactsIn(surface.mesh);
  const notes = [...surface.notes, ...seamNotes(seams, touching.length)];
  const found = { ...surface, ...(seams > 0 ? { seamPoints: seams } : {}), notes };
  return touching.length > 0 ? { ...found, locked: touching } : found;
}

function seamNotes(seams: number, touching: number): string[] {
  const together = `${counted(seams, 'point')} on seams, where several lie in one place, will be reduced together.`;
  const staying = `${counted(touching, 'point')} where sheets touch, but have no edge in common, will stay as they are.`;
  return [...(seams > 0 ? [together] : []), ...(touching > 0 ? [staying] : [])];
}

/** Points that share their place with others, where a sheet ends. */
interface Contacts {
  /** How many of them lie along seams. */
  seams: number;
  /** Those that no seam joins to all others in their place. */
  touching: Uint32Array;
}

function contactsIn({ position, triangles }: Mesh): Contacts {
  const places = placesOf(position);
  if (places.every((first, point) => first === point)) return { seams: 0, touching: new Uint32Array() };
  const ends = sheetEnds(triangles, places.length);
  const joined = joinedAlong(ends, places);
  const used = usedPoints(triangles, places.length);
  const [occupied, shared, split, atEnd] = Array.from({ length: 4 }, () => new Uint8Array(places.length)); // by place
  const first = new Uint32Array(places.length);
  for (const point of ends) atEnd[places[point]] = 1;
  for (const point of used) {
    const place = places[point];
    if (occupied[place]) {
      shared[place] = 1;
      if (joined.root(point) !== joined.root(first[place])) split[place] = 1;
    }
    if (!occupied[place]) first[place] = point;
    occupied[place] = 1;
  }
  const contacts = used.filter((point) => shared[places[point]] && atEnd[places[point]]);
  const touching = contacts.filter((point) => split[places[point]]);
  return { seams: contacts.length - touching.length, touching };
}

/** The points, joined where they are the ends of edges that run between the same two places, as the core joins them. */
function joinedAlong(ends: Uint32Array, places: Uint32Array): Partition {
  const fromLower = ends.slice();
  for (let i = 0; i < ends.length; i += 2) {
    if (places[ends[i]] > places[ends[i + 1]]) [fromLower[i], fromLower[i + 1]] = [ends[i + 1], ends[i]];
  }
  const values = Float64Array.from(fromLower, (point) => places[point]);
  const joined = new Partition(places.length);
  for (const [edge, same] of firstOfEqual([{ values, components: 2 }], values.length / 2).entries()) {
    if (values[2 * edge] === values[2 * edge + 1]) continue;
    joined.join(fromLower[2 * edge], fromLower[2 * same]);
    joined.join(fromLower[2 * edge + 1], fromLower[2 * same + 1]);
  }
  return joined;
}

function usedPoints(triangles: Uint32Array, points: number): Uint32Array {
  const used = new Uint8Array(points);
  for (const corner of triangles) used[corner] = 1;
  return Uint32Array.from(used.keys()).filter((point) => used[point] === 1);
}
